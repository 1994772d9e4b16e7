// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/pipeline.hpp"

#include <chrono>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "planes/support.hpp"

namespace planescope {
namespace {

// Milliseconds since it was made or last asked.
class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double, std::milli> passed = now - start_;
    start_ = now;
    return passed.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<Plane> selected_planes(const PlaneSelection& selection) {
  std::vector<Plane> planes;
  for (const std::uint32_t s : selection.selected) planes.push_back(selection.hypotheses[s].plane);
  return planes;
}

// What holds for a patch holds for its points.
void label_points(Segmentation& scene) {
  const std::vector<std::int32_t>& point_patch = scene.graph.point_patch;
  scene.point_label.resize(point_patch.size());
  scene.point_plane.resize(point_patch.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, point_patch.size(), 65536), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const bool in_patch = point_patch[i] != kNone;
          const auto p = static_cast<std::size_t>(point_patch[i]);
          scene.point_label[i] = in_patch ? scene.segments.patch_label[p] : kNoSegment;
          scene.point_plane[i] = in_patch ? scene.patch_plane[p].plane : kNone;
        }
      });
}

}  // namespace

Segmentation segment(const PointCloud& cloud, const Options& options, const Progress& progress) {
  options.validate();
  Segmentation scene;
  scene.options = options;
  StageTimes& times = scene.times;
  Stopwatch watch;

  scene.graph = make_patches(cloud, options.patches, progress);  // III-A
  times.patches = watch.lap();
  std::vector<PlaneHypothesis> hypotheses =
      propose_planes(scene.graph, options.planes, progress);  // IV-A
  times.hypotheses = watch.lap();
  scene.selection =
      select_planes(scene.graph, std::move(hypotheses), options.planes, progress);  // IV-B
  times.selection = watch.lap();
  const std::vector<std::int32_t> assignment = assign_planes(
      scene.graph, selected_planes(scene.selection), options.planes, progress);  // IV-C
  Support support = refit_planes(scene.graph, scene.selection, assignment, options.planes);
  scene.planes = std::move(support.planes);
  scene.patch_plane = std::move(support.patch_plane);
  times.assignment = watch.lap();
  scene.edges = classify_edges(scene.graph, scene.patch_plane, options.edges);  // III-B, eq. (1)
  times.edges = watch.lap();
  scene.segments = connect_segments(scene.graph, scene.edges, scene.patch_plane, options.segments);
  label_points(scene);
  times.segments = watch.lap();
  return scene;
}

}  // namespace planescope
