// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "patches/voxel_blocks.hpp"
#include "patches/voxel_grid.hpp"

namespace planescope {

/// Fills the 26-neighbourhood of each voxel: grid.neighbour_offsets and grid.neighbours, every row
/// ascending by cell (z, y, x). No block may lie at 2^kBlockBits - 1 along an axis.
void link_voxels(const VoxelBlocks& blocks, VoxelGrid& grid);

}  // namespace planescope
