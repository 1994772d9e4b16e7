// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fusion/carving.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace planescope::fusion {

NearestDepth::NearestDepth(const RangeImage& image) {
  levels_.push_back(
      {static_cast<int>(image.lens.width), static_cast<int>(image.lens.height), image.depth});
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.depth.reserve(static_cast<std::size_t>(std::ptrdiff_t{coarse.width} * coarse.height));
    for (int y = 0; y < coarse.height; ++y) {
      const int y0 = 2 * y, y1 = std::min(2 * y + 1, fine.height - 1);
      for (int x = 0; x < coarse.width; ++x) {
        const int x0 = 2 * x, x1 = std::min(2 * x + 1, fine.width - 1);
        const auto at = [&](int column, int row) {
          return fine.depth[static_cast<std::size_t>(std::ptrdiff_t{row} * fine.width + column)];
        };
        coarse.depth.push_back(std::min({at(x0, y0), at(x1, y0), at(x0, y1), at(x1, y1)}));
      }
    }
    levels_.push_back(std::move(coarse));
  }
}

float NearestDepth::find(int left, int top, int right, int bottom) const {
  std::size_t level = 0;
  for (int side = std::max(right - left, bottom - top); side > 2; side /= 2) ++level;
  level = std::min(level, levels_.size() - 1);
  const Level& chosen = levels_[level];
  float nearest = std::numeric_limits<float>::infinity();
  for (int y = top >> level; y <= bottom >> level; ++y) {
    for (int x = left >> level; x <= right >> level; ++x) {
      nearest = std::min(
          nearest, chosen.depth[static_cast<std::size_t>(std::ptrdiff_t{y} * chosen.width + x)]);
    }
  }
  return nearest;
}

namespace {

/// Nearest depth seen around a block, where the frame sees all of it at some distance; else 0.
float depth_around(const NearestDepth& depth, const PinholeCamera& lens, const Eigen::Vector3d& p,
                   double radius) {
  const double near = p.z() - radius;
  if (near < 0.05) return 0;
  const double u = lens.fx * p.x() / p.z() + lens.cx, v = lens.fy * p.y() / p.z() + lens.cy;
  // The ball's outline lies within this, up to the few degrees that it is off the axis.
  const double reach = 1.5 * std::max(lens.fx, lens.fy) * radius / near + 1;
  if (!(u - reach >= 0 && v - reach >= 0 && u + reach < lens.width - 1 &&
        v + reach < lens.height - 1)) {
    return 0;
  }
  return depth.find(static_cast<int>(u - reach), static_cast<int>(v - reach),
                    static_cast<int>(u + reach) + 1, static_cast<int>(v + reach) + 1);
}

/// \returns whether anything was behind a surface.
bool free_block(Block& block, float weight) {
  bool any = false;
  for (std::size_t v = 0; v < kVoxels; ++v) {
    if (block.weight[v] == 0) continue;
    any = any || block.distance[v] < 0;
    block.weight[v] += weight;
    block.distance[v] += (1 - block.distance[v]) * (weight / block.weight[v]);
  }
  return any;
}

}  // namespace

void carve(const RangeImage& image, const Eigen::Isometry3d& pose, const FusionOptions& options,
           std::uint32_t frame, const BlockMap& blocks) {
  const NearestDepth depth(image);
  const Eigen::Isometry3d to_camera = pose.inverse();
  const double side = kSide * options.voxel_size;
  const double radius = side * std::numbers::sqrt3 / 2;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size(), 256), [&](const auto& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b) {
      Block& block = *blocks.blocks()[b];
      if (!block.behind) continue;
      const Eigen::Vector3d centre =
          to_camera *
          ((Eigen::Vector3d(block.key.x, block.key.y, block.key.z).array() + 0.5) * side).matrix();
      const float seen = depth_around(depth, image.lens, centre, radius);
      if (seen == 0 || double(seen) <= centre.z() + radius + options.truncation) continue;
      // Weighs like a return from the block's own depth: that it is free is as sure as that.
      block.behind = free_block(block, frame_weight(static_cast<float>(centre.z())));
      block.changed = frame;
    }
  });
}

}  // namespace planescope::fusion
