// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "planescope/track.hpp"
#include "synthesis_fixtures.hpp"

namespace planescope::testing {

inline constexpr double kPiece = 0.16;  // [m]

using Pieces = std::vector<SurfacePiece>;

/// The cloud's points by cells of a grid, those that `take` takes.
inline Pieces cut(const PointCloud& cloud,
                  const std::function<bool(const Eigen::Vector3f&)>& take) {
  std::map<BlockKey, PointCloud> cells;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    const auto part = [](float v) { return static_cast<std::int32_t>(std::floor(v / kPiece)); };
    if (!take(p)) continue;
    PointCloud& cell = cells[{part(p.x()), part(p.y()), part(p.z())}];
    cell.positions.push_back(p);
    cell.normals.push_back(cloud.normals[i]);
  }
  Pieces pieces;
  for (auto& [key, points] : cells) pieces.push_back({key, std::move(points)});
  return pieces;
}

inline Pieces all(const PointCloud& cloud) {
  return cut(cloud, [](const Eigen::Vector3f&) { return true; });
}

/// The same places, empty.
inline Pieces emptied(Pieces pieces) {
  for (SurfacePiece& piece : pieces) piece.points = {};
  return pieces;
}

/// A rectangle at height z, facing up, a point a square centimetre.
inline PointCloud level(double x0, double x1, double y0, double y1, double z) {
  PointCloud cloud;
  for (double x = x0 + 0.005; x < x1; x += 0.01) {
    for (double y = y0 + 0.005; y < y1; y += 0.01) {
      cloud.positions.push_back(Eigen::Vector3d(x, y, z).cast<float>());
      cloud.normals.push_back(Eigen::Vector3f::UnitZ());
    }
  }
  return cloud;
}

inline PointCloud make_room(std::uint64_t seed, std::uint64_t points = 300'000) {
  SynthesisOptions options = evenly(seed, points);
  options.normals = true;
  return synthesize(options).cloud;
}

/// The room as it is seen by the k-th of five looks: a slab of it.
inline Pieces slab(const PointCloud& room, std::uint32_t k) {
  const double from = -5 + 2.0 * k, to = from + 2;
  return cut(room, [&](const Eigen::Vector3f& p) {
    const double x = std::floor(double(p.x()) / kPiece) * kPiece;
    return x >= from && x < to;
  });
}

/// A room that is seen in five slabs, one after the other.
inline void scan(MapTracker& tracker, const PointCloud& room) {
  for (std::uint32_t k = 0; k < 5; ++k) tracker.update(k, slab(room, k));
}

}  // namespace planescope::testing
