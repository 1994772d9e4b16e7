// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/render.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkVersion.h>

#include "animation.hpp"
#include "drawing.hpp"
#include "figure.hpp"
#include "geometry.hpp"
#include "geometry_files.hpp"
#include "image.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "provenance.hpp"
#include "scene_data.hpp"
#include "validate.hpp"
#include "vtk_arrays.hpp"
#include "window.hpp"

namespace planescope {
namespace {

Camera render_one(const draw::SceneData& scene, const RenderOptions& options,
                  const std::filesystem::path& png,
                  std::unique_ptr<draw::Window> window = nullptr) {
  draw::Drawing drawing(scene, options, draw::Fit::Scene, std::move(window));
  const draw::Annotation words = draw::describe(scene, options.layers, options.annotation.title);
  const draw::Image image = drawing.draw(options.layers, options.size, words, options.color_by);
  Camera camera = draw::in_world(drawing.camera(), scene);
  draw::write_png(image, png, draw::provenance(scene, options, options.layers, camera));
  return camera;
}

/// A window for one picture: OpenGL starts while the scene is read.
std::unique_ptr<draw::Window> start_window(const RenderOptions& options) {
  auto window = std::make_unique<draw::Window>();
  const auto side = [&](int pixels) { return std::int64_t{pixels} * options.supersample; };
  const auto [width, height] = options.size;
  if (std::max(side(width), side(height)) <= window->max_size() &&
      side(width) * side(height) <= draw::kMostPixels)
    window->prepare(static_cast<int>(side(width)), static_cast<int>(side(height)));
  return window;
}

draw::Pixel to_pixel(const std::array<double, 3>& color) {
  draw::Pixel pixel{};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0, 1.0)));
  return pixel;
}

}  // namespace

Camera render(const Segmentation& scene, const PointCloud& cloud, const RenderOptions& options,
              const std::filesystem::path& png) {
  draw::validate(options);
  return render_one(draw::scene_data(scene, cloud), options, png);
}

Camera render(const std::filesystem::path& folder, const RenderOptions& options,
              const std::filesystem::path& png) {
  draw::validate(options);
  auto loading = std::async(std::launch::async, [&] { return draw::scene_data(folder); });
  std::unique_ptr<draw::Window> window;
  std::exception_ptr failure;  // what is wrong with the folder is said first
  try {
    window = start_window(options);
  } catch (...) {
    failure = std::current_exception();
  }
  const draw::SceneData scene = loading.get();
  if (failure) std::rethrow_exception(failure);
  return render_one(scene, options, png, std::move(window));
}

ColorDifferences color_differences(const std::filesystem::path& folder,
                                   const RenderOptions& options) {
  const draw::SceneData scene = draw::scene_data(folder);
  const draw::Neighbours pairs = draw::segment_neighbours(scene);
  const auto least = draw::least_differences(draw::scene_colors(scene, options).segments, pairs);
  return {least[0], least[1], least[2], least[3], least[4], pairs.size()};
}

void render_orbit(const std::filesystem::path& folder, const RenderOptions& options, int frames,
                  const std::filesystem::path& png) {
  draw::validate(options);
  if (frames < 2 || frames > 360)
    throw Error(Error::Kind::Usage,
                "orbit " + std::to_string(frames) + ": must be 2 to 360 frames");
  const draw::SceneData scene = draw::scene_data(folder);
  const draw::Shot shot(scene, options);
  const double start = draw::azimuth(shot.view(), shot.axes());
  const draw::Annotation words = draw::describe(scene, options.layers, options.annotation.title);
  std::vector<std::string> pictures;
  for (int i = 0; i < frames; ++i) {
    RenderOptions turned = options;
    turned.camera.azimuth = std::remainder(start + 360.0 * i / frames, 360.0);
    // A drawing each: other walls stand in the way.
    draw::Drawing drawing(scene, turned, draw::Fit::Around);
    const draw::Image image = drawing.draw(options.layers, options.size, words, options.color_by);
    const Camera camera = draw::in_world(drawing.camera(), scene);
    pictures.push_back(
        draw::encode_png(image, i == 0 ? draw::provenance(scene, options, options.layers, camera)
                                       : draw::PngNotes{}));
  }
  constexpr int kTurn = 10'000;  // [ms]
  write_whole(png, draw::animate(pictures, kTurn / frames));
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
  const auto notes = [&](Layer layers) {
    return draw::provenance(data, options, layers, draw::in_world(drawing.camera(), data));
  };
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (i == 0 && !shared) continue;  // the scene is a panel only
    pictures.push_back(drawing.draw(panels[i].layers, options.size, panels[i].annotation));
    if (i == 0) continue;
    writes.push_back(
        std::async(std::launch::async,
                   [picture = pictures.back(), file = folder / names[i],
                    said = notes(panels[i].layers)] { draw::write_png(picture, file, said); }));
  }
  const draw::Pixel ground = to_pixel(options.background);
  draw::write_png(shared ? draw::arrange(pictures, 2, options.size, ground)
                         : draw::draw_panels(drawing, panels, 2, options.size, ground),
                  folder / "overview.png", notes(Layer::Scene));
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
  if (std::filesystem::exists(folder / "result.json"))
    add_files(folder, {"patches.vtp", "graph.vtp", "planes.vtp"});
}

std::vector<EdgeState> stored_edges(const Result& result, const std::filesystem::path& folder) {
  const auto graph = draw::read_graph(result, folder);
  vtkDataArray& on = *graph->GetCellData()->GetArray("on");
  vtkDataArray& rule = *graph->GetCellData()->GetArray("rule");
  std::vector<EdgeState> edges;
  for (vtkIdType i = 0; i < graph->GetNumberOfLines(); ++i) {
    const auto ends = draw::corners(*graph->GetLines(), i);
    edges.push_back({static_cast<std::uint32_t>(ends[0]), static_cast<std::uint32_t>(ends[1]),
                     on.GetTuple1(i) != 0, static_cast<EdgeRule>(rule.GetTuple1(i))});
  }
  return edges;
}

std::string gl_renderer() { return draw::Window().renderer(); }

std::string vtk_version() { return vtkVersion::GetVTKVersion(); }

}  // namespace planescope
