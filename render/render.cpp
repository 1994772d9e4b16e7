// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/render.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>
#include <vector>

#include <vtkVersion.h>

#include "drawing.hpp"
#include "figure.hpp"
#include "geometry.hpp"
#include "geometry_files.hpp"
#include "image.hpp"
#include "planescope/error.hpp"
#include "scene_data.hpp"
#include "window.hpp"

namespace planescope {
namespace {

void render_one(const draw::SceneData& scene, const RenderOptions& options,
                const std::filesystem::path& png) {
  draw::Drawing drawing(scene, options);
  const draw::Annotation words = draw::describe(scene, options.layers, options.title);
  draw::write_png(drawing.draw(options.layers, options.size, words), png);
}

draw::Pixel to_pixel(const std::array<double, 3>& color) {
  draw::Pixel pixel{};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0, 1.0)));
  return pixel;
}

}  // namespace

void render(const Segmentation& scene, const PointCloud& cloud, const RenderOptions& options,
            const std::filesystem::path& png) {
  draw::validate(options);
  render_one(draw::scene_data(scene, cloud), options, png);
}

void render(const std::filesystem::path& folder, const RenderOptions& options,
            const std::filesystem::path& png) {
  draw::validate(options);
  render_one(draw::scene_data(folder), options, png);
}

void render_pictures(const Segmentation& scene, const PointCloud& cloud,
                     const RenderOptions& options, const std::filesystem::path& folder,
                     const InputInfo& input) {
  draw::validate(options);
  const draw::SceneData data = draw::scene_data(scene, cloud, input);
  draw::Drawing drawing(data, options);
  const std::vector<draw::Panel> panels = draw::overview_panels(data);
  const char* const names[] = {nullptr, "segments.png", "planes.png", "graph.png"};
  const bool shared = draw::shrinks_well(options.size);
  std::vector<draw::Image> pictures;
  std::vector<std::future<void>> writes;  // compressed while the next one is drawn
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i == 0 && !shared) continue;  // the scene is a panel only
    pictures.push_back(drawing.draw(panels[i].layers, options.size, panels[i].annotation));
    if (i == 0) continue;
    writes.push_back(
        std::async(std::launch::async, [picture = pictures.back(), &folder, name = names[i]] {
          draw::write_png(picture, folder / name);
        }));
  }
  const draw::Pixel ground = to_pixel(options.background);
  draw::write_png(shared ? draw::arrange(pictures, 2, options.size, ground)
                         : draw::draw_panels(drawing, panels, 2, options.size, ground),
                  folder / "overview.png");
  for (std::future<void>& write : writes) write.get();
}

void save_geometry(const Segmentation& scene, const PointCloud& cloud,
                   const std::filesystem::path& folder) {
  const auto patches = draw::patch_geometry(scene);
  const auto graph = draw::graph_geometry(scene);
  const auto planes = draw::plane_geometry(scene, cloud);
  draw::write_vtp(patches, cloud.origin, folder / "patches.vtp");
  draw::write_vtp(graph, cloud.origin, folder / "graph.vtp");
  draw::write_vtp(planes, cloud.origin, folder / "planes.vtp");
}

std::string gl_renderer() { return draw::Window().renderer(); }

std::string vtk_version() { return vtkVersion::GetVTKVersion(); }

}  // namespace planescope
