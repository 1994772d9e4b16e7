// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include <Eigen/Core>

#include "patches/voxel_grid.hpp"

namespace planescope {

/// Normals over two rings of voxels, unit, sign arbitrary: the principal plane of m + S(m) +
/// S(S(m)), where S sums over the 27-neighbourhood; nearer voxels weigh more. That is what PCL's
/// SupervoxelClustering gathers voxel by voxel.
/// \param mean [m] where the voxels lie: grid.mean, but for warped grids (RangeWarp).
std::vector<Eigen::Vector3f> estimate_voxel_normals(const VoxelGrid& grid,
                                                    const std::vector<Eigen::Vector3f>& mean);

}  // namespace planescope
