// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "figure.hpp"

#include <algorithm>
#include <cmath>

#include "palette.hpp"

namespace planescope::draw {
namespace {

constexpr Pixel kSeparator = {200, 203, 208};

std::size_t finite_points(const SceneData& scene) {
  const auto& positions = scene.result.cloud.positions;
  return static_cast<std::size_t>(std::count_if(positions.begin(), positions.end(), is_finite));
}

}  // namespace

std::string grouped(std::size_t number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

Annotation describe(const SceneData& scene, Layer layers, const std::string& title) {
  Annotation annotation{title, {}, {}};
  if (has(layers, Layer::Graph)) {
    const EdgeCounts counts = count_edges(scene);
    using Swatch = LegendEntry::Swatch;
    annotation.legend = {{Swatch::ThinLine, kEdgeOn, "ON " + grouped(counts.on)},
                         {Swatch::DashedLine, kEdgeOff, "OFF " + grouped(counts.off)}};
  }
  return annotation;
}

std::vector<Panel> overview_panels(const SceneData& scene) {
  const Result& result = scene.result;
  const auto panel = [&](Layer layers, const std::string& title) {
    return Panel{layers, describe(scene, layers, title)};
  };
  const std::size_t edges = static_cast<std::size_t>(scene.graph->GetNumberOfCells());
  const std::size_t planes = count_planes(result.planes, PlaneRole::Support);
  const std::size_t faces = result.planes.size() - planes;
  // A peer has no 0 of what it cannot have.
  const auto count = [&](bool has, std::size_t number) {
    return has ? grouped(number) : "none, " + result.method.name + " has no such thing";
  };
  return {panel(Layer::Scene, "Scene: " + grouped(finite_points(scene)) + " points"),
          panel(Layer::Segments, "Segments: " + grouped(result.segments.size())),
          panel(Layer::Planes, "Planes: " + count(result.method.has_planes, planes) +
                                   (faces > 0 ? ", faces: " + grouped(faces) : "")),
          panel(Layer::Graph, "Edges: " + count(result.method.has_graph, edges))};
}

namespace {

/// Where panels go.
struct Grid {
  Grid(std::size_t count, std::size_t columns, const std::array<int, 2>& size)
      : across(static_cast<int>(columns)),
        down(static_cast<int>((count + columns - 1) / columns)),
        line(std::max(1, size[1] / 700)),
        width((size[0] - line * (across - 1)) / across),
        height((size[1] - line * (down - 1)) / down) {}
  int across, down, line, width, height;
};

}  // namespace

std::array<int, 2> panel_size(std::size_t count, std::size_t columns,
                              const std::array<int, 2>& size) {
  const Grid grid(count, columns, size);
  return {grid.width, grid.height};
}

bool shrinks_well(const std::array<int, 2>& size) {
  constexpr double kLeastArea = 700.0 * 700.0;  // there letters are 8 pixels high in panels
  return static_cast<double>(size[0]) * size[1] >= kLeastArea;
}

Image arrange(const std::vector<Image>& pictures, std::size_t columns,
              const std::array<int, 2>& size, const Pixel& background) {
  const Grid grid(pictures.size(), columns, size);
  Image canvas = filled(size[0], size[1], background);
  for (int i = 1; i < grid.across; ++i)
    paste(canvas, filled(grid.line, size[1], kSeparator), i * grid.width + (i - 1) * grid.line, 0);
  for (int i = 1; i < grid.down; ++i)
    paste(canvas, filled(size[0], grid.line, kSeparator), 0, i * grid.height + (i - 1) * grid.line);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int column = static_cast<int>(i) % grid.across, row = static_cast<int>(i) / grid.across;
    paste(canvas, shrunk(pictures[i], grid.width, grid.height), column * (grid.width + grid.line),
          row * (grid.height + grid.line));
  }
  return canvas;
}

Image draw_panels(Drawing& drawing, const std::vector<Panel>& panels, std::size_t columns,
                  const std::array<int, 2>& size, const Pixel& background) {
  const std::array<int, 2> one = panel_size(panels.size(), columns, size);
  std::vector<Image> pictures;
  pictures.reserve(panels.size());
  for (const Panel& panel : panels)
    pictures.push_back(drawing.draw(panel.layers, one, panel.annotation));
  return arrange(pictures, columns, size, background);
}

}  // namespace planescope::draw
