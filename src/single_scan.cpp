// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "single_scan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace planescope {
namespace {

constexpr std::size_t kFewestPoints = 2000;   // of fewer, directions tell nothing
constexpr std::size_t kMostPoints = 400'000;  // that are sorted by direction
constexpr float kCell = 0.02f;                // of unit directions along each axis: about a degree
// Single views and scans have 0.9 to 0.98 and 0.004 to 0.04, fused maps 0 to 0.75 and 0.14 to 0.77.
constexpr double kLeastCorrelation = 0.6, kMostLayered = 0.08;

// A direction's cell on the unit cube, 7 bits an axis.
std::uint32_t direction_cell(const Eigen::Vector3f& direction) {
  const auto axis = [&](int a) {
    return static_cast<std::uint32_t>((direction[a] + 1) * (1 / kCell));
  };
  return axis(2) << 14 | axis(1) << 7 | axis(0);
}

}  // namespace

double spacing_correlation(std::span<const Sighting> sightings) {
  double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  for (const Sighting& s : sightings) {
    if (!(s.range > 0 && s.neighbours > 0)) continue;
    const double x = std::log(double(s.range)), y = -0.5 * std::log(double(s.neighbours));
    n += 1, sx += x, sy += y, sxx += x * x, syy += y * y, sxy += x * y;
  }
  const double vx = n * sxx - sx * sx, vy = n * syy - sy * sy;
  return vx > 0 && vy > 0 ? (n * sxy - sx * sy) / std::sqrt(vx * vy) : 0;
}

double layered_share(const PointCloud& cloud, std::span<const std::uint32_t> finite,
                     const Eigen::Vector3f& sensor) {
  const std::size_t count = std::min(finite.size(), kMostPoints);
  std::vector<std::pair<std::uint32_t, float>> rays;  // direction cell, range
  rays.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3f ray = cloud.positions[finite[k * finite.size() / count]] - sensor;
    const float range = ray.norm();
    if (range > 0) rays.emplace_back(direction_cell(ray / range), range);
  }
  std::sort(rays.begin(), rays.end());
  std::size_t shared = 0, layered = 0;
  for (std::size_t begin = 0, end = 0; begin < rays.size(); begin = end) {
    bool gap = false;
    for (end = begin + 1; end < rays.size() && rays[end].first == rays[begin].first; ++end) {
      gap = gap || rays[end].second > 1.25f * rays[end - 1].second;
    }
    if (end - begin < 2) continue;
    shared += end - begin;
    layered += gap ? end - begin : 0;
  }
  return shared > 0 ? double(layered) / double(shared) : 1;
}

bool is_single_scan(const PointCloud& cloud, std::span<const std::uint32_t> finite,
                    std::span<const Sighting> sightings, const Eigen::Vector3f& sensor) {
  return finite.size() >= kFewestPoints && spacing_correlation(sightings) >= kLeastCorrelation &&
         layered_share(cloud, finite, sensor) <= kMostLayered;
}

}  // namespace planescope
