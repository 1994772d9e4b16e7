// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/seen_area.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace planescope::synthesis {
namespace {

constexpr double kCell = 0.05;  // [m]

// Half the extent of a planar surface along its own y.
double half_height(const SurfaceGeometry& geometry) {
  return geometry.shape == SurfaceShape::Disc ? geometry.a : geometry.b;
}

int cell(double x, double half, int count) {
  return std::clamp(static_cast<int>((x / half + 1) / 2 * count), 0, count - 1);
}

}  // namespace

SeenArea::SeenArea(const Scene& scene) : scene_(scene), grids_(scene.surfaces().size()) {
  for (std::size_t s = 0; s < grids_.size(); ++s) {
    const SurfaceGeometry& geometry = scene.surfaces()[s].geometry;
    if (!geometry.planar()) continue;
    Grid& grid = grids_[s];
    // A whole number of cells, so that a face that was seen wholly has its own area.
    grid.columns = std::max(1, static_cast<int>(std::lround(2 * geometry.a / kCell)));
    grid.rows = std::max(1, static_cast<int>(std::lround(2 * half_height(geometry) / kCell)));
    grid.seen.assign(static_cast<std::size_t>(std::ptrdiff_t{grid.columns} * grid.rows), false);
  }
}

void SeenArea::add(const Camera& camera, const DepthView& view, const PointCloud& cloud) {
  for (std::size_t i = 0; i < view.depth.size(); ++i) {
    if (view.surface[i] == kNone || !is_finite(cloud.positions[i])) continue;
    const auto s = static_cast<std::size_t>(view.surface[i]);
    Grid& grid = grids_[s];
    if (grid.seen.empty()) continue;
    const SurfaceGeometry& geometry = scene_.surfaces()[s].geometry;
    const auto width = static_cast<std::size_t>(camera.width);
    const std::size_t across = i % width, down = i / width;
    const Ray ray = camera.ray(static_cast<double>(across), static_cast<double>(down));
    const Vector3d on_face = ray.origin + static_cast<double>(view.depth[i]) * ray.direction;
    const Vector2d place = geometry.at(on_face).texture;
    const int column = cell(place.x(), geometry.a, grid.columns);
    const int row = cell(place.y(), half_height(geometry), grid.rows);
    grid.seen[static_cast<std::size_t>(std::ptrdiff_t{row} * grid.columns + column)] = true;
  }
}

VisiblePart SeenArea::part(std::size_t surface) const {
  const Grid& grid = grids_[surface];
  const SurfaceGeometry& geometry = scene_.surfaces()[surface].geometry;
  VisiblePart part;
  std::size_t seen = 0;
  for (int k = 0; k < static_cast<int>(grid.seen.size()); ++k) {
    if (!grid.seen[static_cast<std::size_t>(k)]) continue;
    const int column = k % grid.columns, row = k / grid.columns;
    const double x = (2 * (column + 0.5) / grid.columns - 1) * geometry.a;
    const double y = (2 * (row + 0.5) / grid.rows - 1) * half_height(geometry);
    part.centroid += geometry.pose * Vector3d(x, y, 0);
    ++seen;
  }
  if (seen == 0) return part;
  part.centroid /= static_cast<double>(seen);
  const double box = 4 * geometry.a * half_height(geometry);
  part.area = std::min(geometry.area(),
                       box * static_cast<double>(seen) / static_cast<double>(grid.seen.size()));
  return part;
}

}  // namespace planescope::synthesis
