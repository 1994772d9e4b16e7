// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/recut_points.hpp"

#include <algorithm>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace planescope {
namespace {

void restore_emptied(const std::vector<std::int32_t>& before, std::span<const std::uint32_t> group,
                     std::vector<std::int32_t>& point_patch) {
  const auto group_of = [&](std::int32_t p) { return group[static_cast<std::size_t>(p)]; };
  enum : std::uint8_t { kNever, kHad, kHas };
  std::vector<std::uint8_t> state(group.size(), kNever);
  for (const std::int32_t p : before) {
    if (p != kNone) state[group_of(p)] = kHad;
  }
  for (const std::int32_t p : point_patch) {
    if (p != kNone) state[group_of(p)] = kHas;
  }
  if (std::find(state.begin(), state.end(), kHad) == state.end()) return;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] != kNone && state[group_of(before[i])] == kHad) point_patch[i] = before[i];
  }
}

}  // namespace

std::vector<std::int32_t> recut_points(const PointCloud& cloud,
                                       std::vector<std::int32_t> point_patch,
                                       const std::vector<PatchDisc>& discs,
                                       const NeighbourTable& rivals, const RecutWeights& weights,
                                       std::span<const std::uint32_t> group) {
  if (rivals.neighbours.empty()) return point_patch;
  const std::vector<std::int32_t> before = std::move(point_patch);
  point_patch = before;
  const auto recut = [&](std::size_t i) {
    const auto own = static_cast<std::size_t>(before[i]);
    if (rivals.offsets[own] == rivals.offsets[own + 1]) return;
    const Eigen::Vector3f& p = cloud.positions[i];
    float least = weights.stay * discs[own].distance(p, weights.along) - discs[own].noise;
    for (std::size_t k = rivals.offsets[own]; k < rivals.offsets[own + 1]; ++k) {
      const std::uint32_t rival = rivals.neighbours[k];
      const float distance = discs[rival].distance(p, weights.along, least);
      if (distance >= least) continue;
      least = distance;
      point_patch[i] = static_cast<std::int32_t>(rival);
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, before.size(), 16384),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        if (before[i] != kNone) recut(i);
                      }
                    });
  restore_emptied(before, group, point_patch);
  return point_patch;
}

}  // namespace planescope
