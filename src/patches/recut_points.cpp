// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/recut_points.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <tbb/parallel_for.h>

namespace planescope {
namespace {

constexpr std::size_t kPart = 16384;  // points a task

struct Move {
  std::size_t point;
  std::int32_t to;
};

/// Patches choose for their points; nothing moves before all have chosen.
class Recut {
 public:
  Recut(const PointCloud& cloud, const std::vector<std::int32_t>& point_patch,
        const std::vector<PatchDisc>& discs, const NeighbourTable& rivals,
        const RecutWeights& weights)
      : cloud_(cloud),
        point_patch_(point_patch),
        discs_(discs),
        rivals_(rivals),
        weights_(weights),
        has_rivals_(discs.size() + 1, 0) {
    for (std::size_t p = 0; p < discs.size(); ++p)
      has_rivals_[p + 1] = rivals.offsets[p] != rivals.offsets[p + 1] ? 1 : 0;
  }

  /// \returns the moves of each part of the cloud, in its order.
  std::vector<std::vector<Move>> choose() const {
    std::vector<std::vector<Move>> parts((point_patch_.size() + kPart - 1) / kPart);
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t part) {
      const std::size_t end = std::min(point_patch_.size(), (part + 1) * kPart);
      choose(part * kPart, end, parts[part]);
    });
    return parts;
  }

 private:
  void choose(std::size_t begin, std::size_t end, std::vector<Move>& moves) const {
    std::array<std::uint32_t, kPart> waiting;
    std::size_t count = 0;
    const std::int32_t* own = point_patch_.data() + begin;
    const std::uint8_t* has_rivals = has_rivals_.data() + 1;  // of kNone: before the first
    static_assert(kNone == -1);
    for (std::size_t i = 0; i < end - begin; ++i) {  // without branches: no one could foresee them
      waiting[count] = static_cast<std::uint32_t>(i);
      count += has_rivals[own[i]];
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = begin + waiting[k];
      const std::int32_t to = nearest(i);
      if (to != point_patch_[i]) moves.push_back({i, to});
    }
  }

  std::int32_t nearest(std::size_t i) const {
    std::int32_t best = point_patch_[i];
    const auto own = static_cast<std::size_t>(best);
    const Eigen::Vector3f& p = cloud_.positions[i];
    float least = weights_.stay * discs_[own].distance(p, weights_.along) - discs_[own].noise;
    for (std::size_t k = rivals_.offsets[own]; k < rivals_.offsets[own + 1]; ++k) {
      const std::uint32_t rival = rivals_.neighbours[k];
      const float distance = discs_[rival].distance(p, weights_.along, least);
      if (distance >= least) continue;
      least = distance;
      best = static_cast<std::int32_t>(rival);
    }
    return best;
  }

  const PointCloud& cloud_;
  const std::vector<std::int32_t>& point_patch_;
  const std::vector<PatchDisc>& discs_;
  const NeighbourTable& rivals_;
  const RecutWeights weights_;
  std::vector<std::uint8_t> has_rivals_;  // of kNone, then per patch
};

std::vector<std::uint32_t> sum_by_group(const std::vector<std::uint32_t>& count,
                                        std::span<const std::uint32_t> group) {
  std::vector<std::uint32_t> sums(count.size(), 0);
  for (std::size_t p = 0; p < count.size(); ++p) sums[group[p]] += count[p];
  return sums;
}

}  // namespace

PointPatches point_patches(const PatchGraph& graph) {
  PointPatches points{graph.point_patch, std::vector<std::uint32_t>(graph.patches.size())};
  std::ranges::transform(graph.patches, points.count.begin(), &Patch::point_count);
  return points;
}

void recut_points(const PointCloud& cloud, PointPatches& points,
                  const std::vector<PatchDisc>& discs, const NeighbourTable& rivals,
                  const RecutWeights& weights, std::span<const std::uint32_t> group) {
  if (rivals.neighbours.empty()) return;
  const auto parts = Recut(cloud, points.patch, discs, rivals, weights).choose();
  const auto for_each_move = [&](const auto& body) {
    for (const auto& moves : parts) {
      for (const Move& move : moves)
        body(points.patch[move.point], static_cast<std::size_t>(points.patch[move.point]),
             static_cast<std::size_t>(move.to));
    }
  };
  std::vector<std::uint32_t> left = points.count;  // were all moves made
  for_each_move([&](std::int32_t, std::size_t from, std::size_t to) { --left[from], ++left[to]; });
  const std::vector<std::uint32_t> in_group = sum_by_group(left, group);
  for_each_move([&](std::int32_t& patch, std::size_t from, std::size_t to) {
    if (in_group[group[from]] == 0) return;
    patch = static_cast<std::int32_t>(to);
    --points.count[from], ++points.count[to];
  });
}

}  // namespace planescope
