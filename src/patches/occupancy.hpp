// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "patches/grid_bounds.hpp"
#include "patches/voxel_blocks.hpp"
#include "planescope/cloud.hpp"

namespace planescope {

/// A point's block and cell have 32 bits together while voxels have no numbers yet: 23 for a block,
/// with room for those that one task may add.
inline constexpr std::size_t kMostBlocks = (std::size_t{1} << 23) - (std::size_t{1} << 15);

/// Finds the occupied voxels of a grid and numbers them.
/// \param bounds its lower corner is that of cell (0, 0, 0); points that it does not take are in no
/// voxel. \param inverse [1/m] voxels a metre; fewer than 2^kAxisBits - 16 of them along an axis.
/// \param point_voxel filled: per point, the number of its voxel, or kNoVoxel.
/// \param most_blocks that a thread gathers before it starts anew; up to kMostBlocks. \returns the
/// blocks, which do not depend on it or on the number of threads.
VoxelBlocks find_occupied(const PointCloud& cloud, const GridBounds& bounds, float inverse,
                          std::vector<std::uint32_t>& point_voxel,
                          std::size_t most_blocks = kMostBlocks);

}  // namespace planescope
