// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include <Eigen/Core>

#include "patches/voxel_blocks.hpp"
#include "planescope/cloud.hpp"

namespace planescope {

/// Finds the occupied voxels of a grid and numbers them.
/// \param lower [m] corner of cell (0, 0, 0), nowhere above a finite point. \param inverse [1/m]
/// voxels a metre; fewer than 2^kAxisBits - 16 of them along an axis.
/// \param point_voxel filled: per point, the number of its voxel, or kNoVoxel. \returns the blocks,
/// which do not depend on the number of threads.
VoxelBlocks find_occupied(const PointCloud& cloud, const Eigen::Vector3f& lower, float inverse,
                          std::vector<std::uint32_t>& point_voxel);

}  // namespace planescope
