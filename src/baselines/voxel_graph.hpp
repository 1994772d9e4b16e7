// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planescope/patches.hpp"

/// \file From points with patch ids to the numbers of patches and borders, without PCL. PCL's own
/// lists are not used for it: a voxel that two seeds chose stays in both patches' lists.
namespace planescope {

/// Occupied voxels that belong to a patch, in the order of their keys.
struct PatchVoxels {
  double voxel_size = 0;                ///< [m]
  std::vector<std::uint64_t> keys;      ///< 21 bits an axis; ascending
  std::vector<Eigen::Vector3f> means;   ///< [m] of each one's points
  std::vector<Eigen::Vector3f> colors;  ///< 0 to 255
  std::vector<std::uint32_t> patch;
};

/// A corner of the voxel grid that PCL's octree lays over points between `low` and `high`: it
/// centres the smallest cube of 2^depth voxels on them.
Eigen::Vector3d octree_origin(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                              double voxel_size);

/// The voxels of PCL's grid over all `points`. All points of a voxel are in one patch, or all in
/// none (kNone): those voxels are left out. `colors` has one entry a point.
PatchVoxels make_voxels(std::span<const Eigen::Vector3f> points, std::span<const Rgb> colors,
                        std::span<const std::int32_t> patch, double voxel_size);

/// Fills voxel_count, centroid, color, curvature and area of every patch; `normal` is read: a plane
/// with normal n crosses (|nx| + |ny| + |nz|) / voxel_size^2 voxels a unit of area.
void measure_patches(const PatchVoxels& voxels, std::vector<Patch>& patches);

/// Patches that touch, sorted: `border` counts the pairs of voxels, one in each patch, that are
/// among each other's 26 neighbours.
std::vector<Adjacency> find_borders(const PatchVoxels& voxels);

}  // namespace planescope
