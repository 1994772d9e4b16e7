// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/seeds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include <Eigen/Geometry>

#include "planes/random.hpp"
#include "planescope/cloud.hpp"

namespace planescope {
namespace {

bool usable(const PatchIndex& index, std::size_t i) {
  return is_finite(index.centroid(i)) && is_finite(index.normal(i));
}

/// The plane through three centroids, if it is well defined and all three normals support it.
std::optional<Plane> plane_of(const PatchIndex& index, const std::array<std::size_t, 3>& triple,
                              float gate) {
  const Eigen::Vector3f a = index.centroid(triple[0]);
  const Eigen::Vector3f u = index.centroid(triple[1]) - a, v = index.centroid(triple[2]) - a;
  const Eigen::Vector3f cross = u.cross(v);
  constexpr float kThin = 0.1f;  // sine of the angle at the first patch, about 6 degrees
  if (!(cross.norm() > kThin * u.norm() * v.norm())) return std::nullopt;
  const Eigen::Vector3f normal = cross.normalized();
  for (const std::size_t i : triple) {
    if (!(std::abs(normal.dot(index.normal(i))) >= gate)) return std::nullopt;
  }
  return Plane{normal, normal.dot(a)};
}

std::vector<std::size_t> positions_within(const PatchIndex& index, std::size_t i, float radius) {
  // A slab wider than the ball is no constraint: only the ball is left of the test.
  const Bits near =
      index.inliers({.plane = {index.normal(i), index.normal(i).dot(index.centroid(i))},
                     .half_width = 2 * radius,
                     .gate = 0,
                     .center = index.centroid(i),
                     .radius = radius});
  std::vector<std::size_t> positions;
  for_each(near, [&](std::size_t k) { positions.push_back(k); });
  return positions;
}

}  // namespace

std::vector<Seed> patch_seeds(const PatchIndex& index, double max_curvature) {
  std::vector<std::pair<float, std::uint32_t>> order;
  const auto limit = static_cast<float>(max_curvature);
  for (std::uint32_t i = 0; i < index.size(); ++i) {
    if (!usable(index, i) || !(index.curvature(i) <= limit)) continue;
    order.emplace_back(-index.area(i) * (limit - index.curvature(i)), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<Seed> seeds;
  seeds.reserve(order.size());
  for (const auto& [score, i] : order) {
    const Eigen::Vector3f normal = index.normal(i), center = index.centroid(i);
    seeds.push_back({{normal, normal.dot(center)}, center, i});
  }
  return seeds;
}

std::vector<Seed> triple_seeds(const PatchIndex& index, const PlaneOptions& options, float radius) {
  std::vector<Seed> seeds;
  if (index.size() < 3) return seeds;
  std::mt19937_64 random(options.random_seed);
  constexpr int kDraws = 16;
  for (std::uint32_t t = 0; t < options.triples; ++t) {
    const std::size_t first = uniform_index(random, index.size());
    if (!usable(index, first)) continue;
    const std::vector<std::size_t> near = positions_within(index, first, radius);
    std::optional<Plane> plane;
    std::array<std::size_t, 3> triple{};
    for (int draw = 0; draw < kDraws && !plane && near.size() >= 3; ++draw) {
      triple = {first, near[uniform_index(random, near.size())],
                near[uniform_index(random, near.size())]};
      plane = plane_of(index, triple, static_cast<float>(options.normal_gate));
    }
    if (!plane) continue;
    const Eigen::Vector3f center =
        (index.centroid(triple[0]) + index.centroid(triple[1]) + index.centroid(triple[2])) / 3;
    seeds.push_back({*plane, center, static_cast<std::uint32_t>(first)});
  }
  return seeds;
}

}  // namespace planescope
