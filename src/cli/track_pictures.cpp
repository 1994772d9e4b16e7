// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/track_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planescope/error.hpp"
#include "planescope/track_pictures.hpp"

namespace planescope::cli {
namespace {

/// A coarse map of the whole sequence, from some of its frames: what a steady camera must see.
PointCloud outline(const Sequence& sequence) {
  constexpr std::size_t kFrames = 30;
  const std::size_t step = std::max<std::size_t>(1, sequence.size() / kFrames);
  TsdfVolume volume({.voxel_size = 0.04, .min_observations = 1});
  for (std::size_t i = 0; i < sequence.size(); i += step) {
    const Frame frame = sequence.read(i);
    volume.integrate(frame.depth, {}, sequence.camera(), frame.info.pose);
  }
  PointCloud map = volume.points();
  map.up = sequence.up();
  return map;
}

/// Patches of the outline's voxels.
Options coarse(Options options) {
  options.patches.voxel_size = std::max(options.patches.voxel_size, 0.08);
  options.patches.patch_size = std::max(options.patches.patch_size, 0.3);
  return options;
}

/// What the sensor sees: its pose and the angle of its lens.
Camera sensor_camera(const Eigen::Isometry3d& pose, const PinholeCamera& lens) {
  Camera camera;
  camera.position = pose.translation();
  camera.focal = pose * Eigen::Vector3d(0, 0, 2);
  camera.up = -pose.linear().col(1);
  camera.view_angle = 2 * std::atan(lens.height / (2 * lens.fy)) * 180 / std::numbers::pi;
  return camera;
}

}  // namespace

TrackCamera::TrackCamera(const std::string& how, const RenderOptions& drawing,
                         const Sequence& sequence, const TrackOptions& options)
    : on_(!how.empty()),
      follows_(how == "sensor"),
      drawing_(drawing),
      lens_(sequence.camera().lens) {
  if (!on_) return;
  for (int& side : drawing_.size) side = std::max(64, side / 2);
  drawing_.cull_front = !follows_;
  if (follows_) return;
  const PointCloud map = outline(sequence);
  drawing_.up = map.up;
  drawing_.camera.fixed = fit_camera(segment(map, coarse(options.engine)), map, drawing_);
}

void TrackCamera::take(const MapTracker& tracker, const TrackStep& step, const FrameInfo& frame,
                       std::vector<std::string>& pictures) const {
  if (!on_ || !step.segmented) return;
  RenderOptions drawing = drawing_;
  if (follows_) drawing.camera.fixed = sensor_camera(frame.pose, lens_);
  std::string picture =
      picture_of(tracker, drawing,
                 "frame " + std::to_string(step.frame) + ": " + std::to_string(step.segments) +
                     " segments, " + std::to_string(step.planes) + " planes");
  if (!picture.empty()) pictures.push_back(std::move(picture));
}

void write_track_pictures(const std::vector<std::string>& pictures, const TrackTables& tables,
                          const std::filesystem::path& folder) {
  constexpr int kShown = 200;  // [ms] a picture
  if (!pictures.empty()) write_animation(pictures, kShown, folder / "growth.png");
  std::vector<TrackPlotRow> rows;
  double kept = 1, steady = 1;
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
  };
  for (std::size_t i = 0; i < tables.steps().size(); ++i) {
    const TrackStep& step = tables.steps()[i];
    if (step.segmented) kept = share(step.kept, step.carried);
    if (step.segmented) steady = share(step.steady_kept, step.steady);
    rows.push_back({step.frame, step.milliseconds, tables.fusion()[i], double(step.segments),
                    double(step.planes), kept, steady});
  }
  if (!rows.empty()) plot_track(rows, "tracking", folder / "track.png");
}

}  // namespace planescope::cli
