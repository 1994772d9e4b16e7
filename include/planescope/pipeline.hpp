// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/edges.hpp"
#include "planescope/options.hpp"
#include "planescope/patches.hpp"
#include "planescope/planes.hpp"
#include "planescope/segments.hpp"

/// \file The whole method: one call a stage, every stage's result kept.
namespace planescope {

/// What a plane does to the graph.
enum class PlaneRole : std::uint8_t {
  Support,  ///< selected by the energy of Section IV: edges to other planes and to things are OFF
  Face,  ///< of an object (planes.face_area): it cuts nothing, but gives its patches their normal
};

/// A plane of the scene, refitted to the patches assigned to it.
struct SupportingPlane {
  Plane plane;
  PlaneRole role = PlaneRole::Support;
  std::uint32_t hypothesis = 0;  ///< index into PlaneSelection::hypotheses; 0 for a face
  std::uint32_t patch_count = 0;
  std::uint32_t point_count = 0;
  float area = 0;  ///< [m^2] of its patches
  float rms = 0;   ///< [m] root mean square distance of its patches' centroids
};

/// Wall-clock time of each stage [ms].
struct StageTimes {
  double read = 0, patches = 0, hypotheses = 0, selection = 0, assignment = 0, edges = 0,
         segments = 0;
};

/// Which method made a segmentation: ours, or a peer that gives the same kind of answer.
struct MethodInfo {
  std::string name = "ours";  ///< `ours`, `ransac`, `lccp`, `cpc`
  bool has_planes = true;     ///< false: the method has no notion of a plane
  bool has_graph = true;      ///< false: it has no patches, and no edges between them
  /// A peer's settings by name; ours are in Segmentation::options.
  std::vector<std::pair<std::string, double>> settings;

  bool is_ours() const { return name == "ours"; }
};

/// `plane` for a supporting plane, `face` for an object's.
std::string_view name(PlaneRole role);

/// How many of the planes have that role.
std::size_t count_planes(const std::vector<SupportingPlane>& planes, PlaneRole role);

/// Everything that segment() found out about a cloud.
struct Segmentation {
  MethodInfo method;
  Options options;           ///< that made it
  PatchGraph graph;          ///< III-A
  PlaneSelection selection;  ///< IV-A, IV-B
  std::vector<SupportingPlane>
      planes;  ///< supporting planes that have patches, by area, descending; then faces likewise
  std::vector<PatchPlane> patch_plane;  ///< IV-C, per patch: supporting plane, or kNone
  std::vector<std::int32_t>
      patch_face;           ///< per patch: face, as index into planes, or kNone; or empty
  std::vector<Edge> edges;  ///< III-B, in the order of graph.adjacency
  SegmentSet segments;
  std::vector<std::uint32_t> point_label;  ///< per point of the cloud: segment label, or kNoSegment
  std::vector<std::int32_t> point_plane;   ///< per point: index into planes, face or not, or kNone
  StageTimes times;

  /// The plane that a patch lies on, supporting or face, or kNone.
  std::int32_t plane_of(std::size_t patch) const {
    if (patch_plane[patch].plane != kNone || patch_face.empty()) return patch_plane[patch].plane;
    return patch_face[patch];
  }
};

/// Runs the method on a cloud.
/// \throws Error{Kind::Usage} options are invalid; \throws Error{Kind::Input} no finite point;
/// \throws Error{Kind::Computation} the cloud does not fit the voxel size, or no patch forms at it.
Segmentation segment(const PointCloud& cloud, const Options& options,
                     const Progress& progress = {});

/// The scene's up direction, unit: the normal of the largest near-horizontal supporting plane. What
/// counts as near-horizontal goes by a prior, which is also the answer where no plane decides:
/// organised views look along +z with y down (or along -z with y up, if that is where their points
/// lie), maps are taken as z-up unless the largest level plane along y is clearly larger, or the
/// cloud says otherwise (PointCloud::up).
Eigen::Vector3f scene_up(const Segmentation& scene, const PointCloud& cloud);

/// An edge's rule and numbers in words, one paragraph.
std::string explain(const Segmentation& scene, const Edge& edge);

}  // namespace planescope
