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
  explicit StageClock(double& first) : running_(&first) {}
  ~StageClock() { start(*running_); }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

  // Ends the running stage and starts the one that `next` counts.
  void start(double& next) {
    const auto now = Clock::now();
    *running_ += std::chrono::duration<double, std::milli>(now - since_).count();
    running_ = &next;
    since_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  double* running_;
  Clock::time_point since_ = Clock::now();
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

std::vector<HeldPlane> select_faces(Segmentation& scene, const PlaneOptions& options,
                                    const HeldPlanes* held) {
  const StageClock clock(scene.times.assignment);
  return select_object_faces(scene.graph, scene.planes, scene.patch_plane, options, held);
}

void add_faces(Segmentation& scene, const PlaneOptions& options,
               const std::vector<HeldPlane>& faces) {
  ObjectFaces placed = place_object_faces(scene.graph, scene.patch_plane, faces, options);
  const auto first = static_cast<std::int32_t>(scene.planes.size());
  scene.planes.insert(scene.planes.end(), placed.planes.begin(), placed.planes.end());
  scene.patch_face = std::move(placed.patch_face);
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

void find_planes(Segmentation& scene, const Options& options, const Progress& progress,
                 HeldPlanes* held) {
  StageClock clock(scene.times.hypotheses);
  scene.selection =
      renew_planes(scene.graph, options.planes, held, [&](std::string_view stage, double fraction) {
        if (stage == "selection" && fraction == 0) clock.start(scene.times.selection);
        if (progress) progress(stage, fraction);
      });
  if (held == nullptr) return;
  held->supporting.clear();
  for (const PlaneHypothesis& h : scene.selection.hypotheses) {
    held->supporting.push_back({h.plane, h.selected});
  }
}

void assign_patches(Segmentation& scene, const Options& options, const Progress& progress) {
  const StageClock clock(scene.times.assignment);
  const std::vector<std::int32_t> assignment =
      assign_planes(scene.graph, selected_planes(scene.selection), options.planes, progress);
  Support support = refit_planes(scene.graph, scene.selection, assignment);
  scene.planes = std::move(support.planes);
  scene.patch_plane = std::move(support.patch_plane);
}

void complete_planes(Segmentation& scene, const Options& options,
                     const std::vector<HeldPlane>& faces) {
  const StageClock clock(scene.times.assignment);
  add_faces(scene, options.planes, faces);
  settle_planes(scene, options.planes, direction_tolerance(options));
}

void connect_patches(Segmentation& scene, const Options& options) {
  StageClock clock(scene.times.edges);
  scene.edges = classify_edges(scene.graph, scene.patch_plane, options.edges);
  clock.start(scene.times.segments);
  scene.segments = connect_segments(scene.graph, scene.edges, scene.patch_plane, options.segments);
}

void segment_graph(Segmentation& scene, const Options& options, const Progress& progress) {
  find_planes(scene, options, progress);
  assign_patches(scene, options, progress);
  complete_planes(scene, options, select_faces(scene, options.planes));
  connect_patches(scene, options);
}

Segmentation segment(const PointCloud& cloud, const Options& options, const Progress& progress) {
  options.validate();
  Segmentation scene;
  scene.options = options;
  const bool scattered = options.patches.smoothing > 0;
  PointCloud smooth;
  const PointCloud& surface = scattered ? smooth : cloud;
  {
    const StageClock clock(scene.times.patches);
    if (scattered) smooth = smooth_points(cloud, options.patches.smoothing);
    scene.graph = make_patches(surface, options.patches, progress);  // III-A
    if (scene.graph.patches.empty()) refuse_scale(cloud, options.patches);
  }
  segment_graph(scene, options, progress);
  {
    const StageClock clock(scene.times.segments);
    label_points(scene, recut_borders(scene, surface));
  }
  return scene;
}

}  // namespace planescope
