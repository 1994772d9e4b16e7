// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "fusion/touched_blocks.hpp"
#include "fusion/voxel_field.hpp"

namespace planescope::fusion {

/// The nearest depth within any rectangle of an image, found in a few steps: minima over squares of
/// 1, 2, 4, ... pixels.
class NearestDepth {
 public:
  explicit NearestDepth(const RangeImage& image);

  /// [m] over columns [left, right] and rows [top, bottom], which lie in the image; 0 where a pixel
  /// has no return.
  float find(int left, int top, int right, int bottom) const;

 private:
  struct Level {
    int width, height;
    std::vector<float> depth;
  };
  std::vector<Level> levels_;
};

/// Surface that a frame looks through is not there: moves the distances of all blocks that lie
/// wholly in front of what the frame saw towards "free". What was fused from a bad return or has
/// been carried away would else stay for ever, because frames are fused near their own returns
/// only.
void carve(const RangeImage& image, const Eigen::Isometry3d& pose, const FusionOptions& options,
           std::uint32_t frame, const BlockMap& blocks);

}  // namespace planescope::fusion
