// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "patches/voxel_grid.hpp"
#include "planescope/cloud.hpp"

namespace planescope {

/// Normals of voxels by the surfels in them: the mean of the surfels' own normals, weighted by the
/// areas pi r^2 of their discs. A mapper has averaged them over many frames, and they know nothing
/// of the surface round the corner, as points of neighbouring voxels do. Voxels without a surfel
/// that has normal and radius, and those whose surfels disagree (both sides of a board), keep what
/// `normals` says.
/// \param normals per voxel, unit. \param cloud with normals and radii.
void take_surfel_normals(const PointCloud& cloud, const VoxelGrid& grid,
                         std::vector<Eigen::Vector3f>& normals);

}  // namespace planescope
