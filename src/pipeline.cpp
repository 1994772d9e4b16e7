// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/pipeline.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "border_points.hpp"
#include "patches/recut_points.hpp"
#include "patches/smoothing.hpp"
#include "planes/object_faces.hpp"
#include "planes/renew_planes.hpp"
#include "planes/shared_directions.hpp"
#include "planes/support.hpp"
#include "planescope/error.hpp"
#include "segment_graph.hpp"

namespace planescope {
namespace {

// Books the time that passes to the stage that runs.
class StageClock {
 public:
  // Ends the running stage and starts the one that `next` counts.
  void start(double& next) {
    const auto now = Clock::now();
    if (running_ != nullptr) {
      *running_ += std::chrono::duration<double, std::milli>(now - since_).count();
    }
    running_ = &next;
    since_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double* running_ = nullptr;
  Clock::time_point since_;
};

std::vector<Plane> selected_planes(const PlaneSelection& selection) {
  std::vector<Plane> planes;
  for (const std::uint32_t s : selection.selected) planes.push_back(selection.hypotheses[s].plane);
  return planes;
}

// No patch has voxels enough to be one: the scale does not fit the cloud.
[[noreturn]] void refuse_scale(const PointCloud& cloud, const PatchOptions& options) {
  const CloudScale scale = measure_scale(cloud);
  std::ostringstream message;
  message << "no surface patch at --voxel-size " << options.voxel_size << " and --patch-size "
          << options.patch_size << ": points lie about " << scale.spacing
          << " m apart, the cloud spans " << scale.extent.norm()
          << " m; take --preset auto, or voxels of some spacings";
  throw Error(Error::Kind::Computation, message.str());
}

}  // namespace

void label_points(Segmentation& scene, const PointPatches& points) {
  const std::vector<std::int32_t>& point_patch = points.patch;
  scene.point_label.resize(point_patch.size());
  scene.point_plane.resize(point_patch.size());
  const std::size_t patches = scene.graph.patches.size();
  std::vector<std::int32_t> patch_plane(patches);
  for (std::size_t p = 0; p < patches; ++p) patch_plane[p] = scene.plane_of(p);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, point_patch.size(), 65536), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const bool in_patch = point_patch[i] != kNone;
          const auto p = static_cast<std::size_t>(point_patch[i]);
          scene.point_label[i] = in_patch ? scene.segments.patch_label[p] : kNoSegment;
          scene.point_plane[i] = in_patch ? patch_plane[p] : kNone;
        }
      });
  for (Segment& segment : scene.segments.segments) segment.point_count = 0;
  for (SupportingPlane& plane : scene.planes) plane.point_count = 0;
  for (std::size_t p = 0; p < patches; ++p) {
    const std::uint32_t label = scene.segments.patch_label[p];
    if (label != kNoSegment) scene.segments.segments[label - 1].point_count += points.count[p];
    if (patch_plane[p] != kNone)
      scene.planes[static_cast<std::size_t>(patch_plane[p])].point_count += points.count[p];
  }
}

std::string_view name(PlaneRole role) { return role == PlaneRole::Face ? "face" : "plane"; }

std::size_t count_planes(const std::vector<SupportingPlane>& planes, PlaneRole role) {
  return static_cast<std::size_t>(std::ranges::count(planes, role, &SupportingPlane::role));
}

void add_faces(Segmentation& scene, const PlaneOptions& options, HeldPlanes* held) {
  ObjectFaces faces =
      find_object_faces(scene.graph, scene.planes, scene.patch_plane, options, held);
  if (held != nullptr) held->faces = std::move(faces.hypotheses);
  const auto first = static_cast<std::int32_t>(scene.planes.size());
  scene.planes.insert(scene.planes.end(), faces.planes.begin(), faces.planes.end());
  scene.patch_face = std::move(faces.patch_face);
  for (std::int32_t& face : scene.patch_face) face = face == kNone ? kNone : first + face;
}

void settle_planes(Segmentation& scene, const PlaneOptions& options,
                   const DirectionTolerance& tolerance) {
  std::vector<std::int32_t> patch_plane(scene.graph.patches.size());
  for (std::size_t i = 0; i < patch_plane.size(); ++i) patch_plane[i] = scene.plane_of(i);
  share_directions(scene.planes, scene.graph.patches, patch_plane, tolerance);
  measure_margins(scene.patch_plane, scene.graph.patches, scene.planes, options);
  for (Patch& patch : scene.graph.patches) patch.own_normal = patch.normal;
  steady_normals(scene.graph.patches, scene.planes, scene.patch_face);
}

void segment_graph(Segmentation& scene, const Options& options, const Progress& progress,
                   HeldPlanes* held) {
  StageTimes& times = scene.times;
  StageClock clock;
  clock.start(times.hypotheses);
  scene.selection = renew_planes(  // IV-A, IV-B
      scene.graph, options.planes, held, [&](std::string_view stage, double fraction) {
        if (stage == "selection" && fraction == 0) clock.start(times.selection);
        if (progress) progress(stage, fraction);
      });
  if (held != nullptr) {
    held->supporting.clear();
    for (const PlaneHypothesis& h : scene.selection.hypotheses) {
      held->supporting.push_back({h.plane, h.selected});
    }
  }
  clock.start(times.assignment);
  const std::vector<std::int32_t> assignment = assign_planes(
      scene.graph, selected_planes(scene.selection), options.planes, progress);  // IV-C
  Support support = refit_planes(scene.graph, scene.selection, assignment);
  scene.planes = std::move(support.planes);
  scene.patch_plane = std::move(support.patch_plane);
  add_faces(scene, options.planes, held);
  settle_planes(scene, options.planes, direction_tolerance(options));
  clock.start(times.edges);
  scene.edges = classify_edges(scene.graph, scene.patch_plane, options.edges);  // III-B, eq. (1)
  clock.start(times.segments);
  scene.segments = connect_segments(scene.graph, scene.edges, scene.patch_plane, options.segments);
  double done = 0;
  clock.start(done);
}

Segmentation segment(const PointCloud& cloud, const Options& options, const Progress& progress) {
  options.validate();
  Segmentation scene;
  scene.options = options;
  StageClock clock;
  clock.start(scene.times.patches);
  const bool scattered = options.patches.smoothing > 0;
  const PointCloud smooth =
      scattered ? smooth_points(cloud, options.patches.smoothing) : PointCloud();
  const PointCloud& surface = scattered ? smooth : cloud;
  scene.graph = make_patches(surface, options.patches, progress);  // III-A
  if (scene.graph.patches.empty()) refuse_scale(cloud, options.patches);
  double other = 0;
  clock.start(other);
  segment_graph(scene, options, progress);
  clock.start(scene.times.segments);
  label_points(scene, recut_borders(scene, surface));
  clock.start(other);
  return scene;
}

}  // namespace planescope
