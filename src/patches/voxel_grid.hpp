// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

namespace planescope {

/// "No voxel": the entry of a non-finite point.
inline constexpr std::uint32_t kNoVoxel = 0xFFFFFFFFu;

/// The occupied voxels of a cloud: the only copy of the cloud's size that the engine makes. Voxels
/// are numbered by block (z, y, x), then by cell: the same numbers whatever the number of threads.
struct VoxelGrid {
  float size = 0;                                   ///< R_voxel [m]
  Eigen::Vector3f lower = Eigen::Vector3f::Zero();  ///< [m] corner of cell (0, 0, 0)
  std::vector<Eigen::Vector3f> mean;                ///< [m] mean position of a voxel's points
  std::vector<Eigen::Vector3f> color;            ///< mean colour, 0 to 255; empty if not asked for
  std::vector<std::uint32_t> point_count;        ///< points in a voxel
  std::vector<std::uint32_t> point_voxel;        ///< per point of the cloud, or kNoVoxel
  std::vector<std::uint32_t> neighbour_offsets;  ///< compressed rows: the 26-neighbourhood ...
  std::vector<std::uint32_t> neighbours;         ///< ... of each voxel, without itself
  std::size_t stray_points = 0;                  ///< finite, far from all others, in no voxel

  std::size_t voxel_count() const { return mean.size(); }
};

/// Voxelises the finite points of a cloud and links each voxel with its up to 26 neighbours.
/// \param with_color also average colours (only where the cloud has them).
/// Strays (find_grid_bounds()) that would make the grid too large are in no voxel.
/// \throws Error{Kind::Input} no finite point; \throws Error{Kind::Computation} more than 2^21
/// voxels along an axis.
VoxelGrid make_voxel_grid(const PointCloud& cloud, double voxel_size, bool with_color);

}  // namespace planescope
