// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "patches/voxel_grid.hpp"
#include "planescope/options.hpp"

namespace planescope {

/// One seed voxel a cell of a grid of `patch_size`: the voxel nearest to the mean of the cell's
/// voxels. Cells with fewer voxels than a twentieth of a disc of half that size are left to their
/// neighbours, as in VCCS. By cell (z, y, x).
std::vector<std::uint32_t> choose_seeds(const VoxelGrid& grid, double patch_size);

/// Grows patches from the seeds over adjacent voxels: synchronous sweeps, in each of which a voxel
/// goes to the adjacent patch at the smallest (distance, patch) if that is nearer than its own. The
/// distance is VCCS's: spatial in units of patch_size, normals by 1 - |n . n'|, colour in units of
/// 255. After 1.8 patch_size / voxel_size sweeps only voxels that are still free go on being
/// claimed, until each one that touches a patch is in one. \param normals of the voxels, sign
/// arbitrary. \returns per voxel: index of its seed, or kNone.
std::vector<std::int32_t> grow_patches(const VoxelGrid& grid,
                                       const std::vector<Eigen::Vector3f>& normals,
                                       const std::vector<std::uint32_t>& seeds,
                                       const PatchOptions& options);

}  // namespace planescope
