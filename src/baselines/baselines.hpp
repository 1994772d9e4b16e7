// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/options.hpp"
#include "planescope/patches.hpp"
#include "planescope/planes.hpp"

/// \file The peers that planescope is compared with, on the same input and with the same kind of
/// answer. They are PCL's own classes; no PCL type crosses this header. All are deterministic and
/// run on one thread. PCL's console verbosity, which is global to the process, is lowered while
/// they run: call them from one thread at a time.
namespace planescope {

/// Sequential plane RANSAC and Euclidean clusters of the rest, the paper's first baseline. The
/// defaults are the settings of the table-top reference scores.
struct RansacOptions {
  double voxel_size = 0.0075;    ///< [m] the cloud is thinned to voxel means; 0: full resolution
  double threshold = 0.01;       ///< [m] distance of a plane's inliers
  double min_plane_share = 0.1;  ///< [1] a plane has at least this share of all voxels (points)
  std::uint32_t max_iterations = 1000;   ///< samples drawn for a plane, at most
  double cluster_tolerance = 0.02;       ///< [m] points of a cluster are chained by at most this
  std::uint32_t min_cluster_size = 100;  ///< [voxels] smaller clusters stay unlabelled
  std::uint64_t random_seed = 1;         ///< the order in which voxels are offered to sampling
};

/// LCCP (Stein et al., CVPR 2014) on PCL's supervoxels, with the settings of PCL's example program.
struct LccpOptions {
  PatchOptions patches{.voxel_size = 0.0075, .patch_size = 0.03};
  double concavity_tolerance = 10.0;    ///< [deg] concave edges below it are ON
  double smoothness_tolerance = 0.1;    ///< [1] allowed step, in voxel sizes
  bool sanity_criterion = true;         ///< edges of patches that touch in one place are OFF
  std::uint32_t convex_neighbours = 1;  ///< k of extended convexity; 0 switches it off
  std::uint32_t min_patches = 3;        ///< segments of at most this many patches are merged
  bool keep_graph = true;  ///< fill PeerResult::graph and edge_on; off: only the labels, and no
                           ///< time or memory beyond PCL's own
};

/// CPC (Schoeler et al., CVPR 2015): LCCP, then cuts by planes through concave edges.
struct CpcOptions {
  LccpOptions lccp;
  std::uint32_t max_cuts = 25;              ///< levels of cutting
  std::uint32_t min_edges = 400;            ///< segments with fewer edges are not cut
  double min_score = 0.16;                  ///< [1] a cut scores at least this
  bool local = true;                        ///< a cut stays within its connected support
  bool directed = true;                     ///< prefer cuts across the edges' direction
  bool clean = false;                       ///< cut only edges that the plane separates
  std::uint32_t ransac_iterations = 10000;  ///< samples drawn for a cut
};

/// Wall-clock time [ms] of PCL's own calls, and of what we do around them.
struct PeerTimes {
  double convert = 0;   ///< our cloud to PCL's, and the results to ours (not PCL's)
  double patches = 0;   ///< thinning, or supervoxels and their adjacency
  double segments = 0;  ///< planes and clusters, or LCCP or CPC
  double labels = 0;    ///< segments to points

  double method() const { return patches + segments + labels; }  ///< without `convert`
};

/// What a peer found out about a cloud. Where a method has no planes or no graph, it says so.
struct PeerResult {
  std::string method;                      ///< `ransac`, `lccp`, `cpc`
  std::vector<std::uint32_t> point_label;  ///< per point: from 1, largest first; or kNoSegment
  std::uint32_t segment_count = 0;
  bool has_planes = false;                ///< the method finds planes (maybe none here)
  std::vector<Plane> planes;              ///< in the order found
  std::vector<std::int32_t> point_plane;  ///< per point: index into planes, or kNone
  bool has_graph = false;                 ///< the method has a patch graph, and it was kept
  PatchGraph graph;
  std::vector<bool> edge_on;  ///< per graph.adjacency: PCL joins the two patches directly
  PeerTimes times;
};

/// PCL's SupervoxelClustering, the reference for make_patches(): without the single-camera
/// transform (PCL switches it on by itself for organised clouds). Normals: the given ones; without
/// them PCL turns its own towards the sensor, or towards (0,0,0) where that is not known. Ids
/// follow PCL's labels; a voxel of a surface that no supervoxel kept stays kNone (PCL leaves such
/// holes). Curvature is by PCA over the patch's voxel means (PCL's own is always 0).
/// \throws Error{Kind::Input} no finite point. \throws Error{Kind::Usage} radii that make no sense.
/// \throws Error{Kind::Computation} the extent is more than 2^21 voxels along an axis.
PatchGraph pcl_patches(const PointCloud& cloud, const PatchOptions& options);

/// Sequential plane RANSAC (PCL's SACSegmentation, refined by least squares): the largest plane is
/// taken while it holds at least `min_plane_share` of all voxels; then Euclidean clusters. Planes'
/// normals point to the sensor where it is known, else along the positive side of their largest
/// component. \throws as pcl_patches().
PeerResult ransac(const PointCloud& cloud, const RansacOptions& options = {});

/// LCCP over PCL's supervoxels. \throws as pcl_patches().
PeerResult lccp(const PointCloud& cloud, const LccpOptions& options = {});

/// CPC over PCL's supervoxels. \throws as pcl_patches().
PeerResult cpc(const PointCloud& cloud, const CpcOptions& options = {});

}  // namespace planescope
