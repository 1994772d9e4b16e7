// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/project.hpp"

namespace planescope::fusion {

/// A depth image in metres, 0 where there is no return.
struct RangeImage {
  PinholeCamera lens;
  std::vector<float> depth;  ///< [m]
};

/// Packed keys of the blocks that the image's rays pass within `truncation` of their returns,
/// ascending. \param pose camera to the field's frame. \throws Error{Kind::Computation} one lies
/// outside the field's reach.
std::vector<std::uint64_t> find_touched_blocks(const RangeImage& image,
                                               const Eigen::Isometry3d& pose, double voxel_size,
                                               double truncation);

}  // namespace planescope::fusion
