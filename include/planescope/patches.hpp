// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"
#include "planescope/options.hpp"

/// \file Section III-A of the paper: the cloud becomes surface patches and their adjacency graph.
namespace planescope {

/// A surface patch v_i: a small, nearly flat piece of surface, grown over adjacent voxels.
struct Patch {
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  ///< c_i [m], mean of its voxels' means
  Eigen::Vector3f normal =
      Eigen::Vector3f::UnitZ();  ///< n_i, unit; towards the side from which it was seen
  /// The normal that the patch's own voxels give; `normal` but for patches on a face, which have
  /// the face's.
  Eigen::Vector3f own_normal = Eigen::Vector3f::UnitZ();
  float curvature = 0;  ///< u_i = l0 / (l0 + l1 + l2) of the PCA over its voxels, in [0, 1/3]
  float area = 0;       ///< [m^2] about (number of voxels) * voxel_size^2, slant corrected
  float scale = 1;      ///< [1] size of its voxels in units of voxel_size (see range_exponent);
                        ///< lengths such as sigma are multiplied with it
  std::uint32_t point_count = 0;  ///< points of the cloud in it
  std::uint32_t voxel_count = 0;  ///< voxels in it
  Eigen::Vector3f color =
      Eigen::Vector3f::Zero();  ///< mean colour, 0 to 255; zero where the cloud has none
};

/// Two patches that touch; first < second.
struct Adjacency {
  std::uint32_t first = 0, second = 0;
  std::uint32_t border =
      0;  ///< pairs of adjacent voxels across: the length of the shared border in voxels
  bool operator==(const Adjacency&) const = default;
};

/// The patches, the graph that they form, and which patch each point belongs to.
struct PatchGraph {
  std::vector<Patch> patches;             ///< index = patch id, contiguous from 0
  std::vector<Adjacency> adjacency;       ///< sorted by (first, second), each pair once
  std::vector<std::int32_t> point_patch;  ///< per point of the cloud: patch id, or kNone
  float voxel_size = 0;                   ///< R_voxel [m] that made them
  float patch_size = 0;                   ///< R_seed [m] that made them
  std::size_t stray_points = 0;           ///< finite, but too far from all others to be in a patch
};

/// Neighbours of every patch in compressed rows: those of patch i are
/// `neighbours[offsets[i]] .. neighbours[offsets[i + 1] - 1]`, ascending; `edges` holds the index
/// into `adjacency`.
struct NeighbourTable {
  std::vector<std::uint32_t> offsets, neighbours, edges;
};

/// Builds the compressed neighbour rows of a graph with `patch_count` patches.
NeighbourTable make_neighbour_table(std::size_t patch_count,
                                    const std::vector<Adjacency>& adjacency);

/// Voxelises the cloud at `voxel_size`, estimates normals over two rings of voxels, and grows
/// patches from seeds at distance `patch_size` over adjacent voxels (VCCS, Papon et al., CVPR
/// 2013). Every finite point ends in a patch or, if no seed reaches its voxel, in kNone;
/// at creases points go to the nearer surface, whatever voxel they are in. Normals
/// point to the cloud's sensor where it is known, else agree with given normals, else are made
/// consistent over the graph and turned to the inside of the scene. A few points so far away that
/// the grid would not hold them are left out, and counted. Same patches at any thread
/// count. \throws Error{Kind::Input} no finite point. \throws Error{Kind::Computation} the extent
/// is more than 2^21 voxels along an axis.
PatchGraph make_patches(const PointCloud& cloud, const PatchOptions& options,
                        const Progress& progress = {});

}  // namespace planescope
