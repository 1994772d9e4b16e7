// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "camera.hpp"
#include "planescope/render.hpp"
#include "scene_data.hpp"
#include "viewpoint.hpp"

/// \file From where a scene is drawn, and what of it.
namespace planescope::draw {

/// How the frame is fitted. Around: to all that the scene sweeps when it is turned about its
/// upright middle, so that all azimuths have one scale.
enum class Fit { Scene, Around };

/// The camera of all pictures of one drawing, whatever their size, and what stands in its way.
class Shot {
 public:
  /// \throws Error{Kind::Input} nothing is finite, or the folder of CameraOptions::fit is none;
  /// \throws Error{Kind::Usage} there is no such sensor, segment or plane.
  Shot(const SceneData& scene, const RenderOptions& options, Fit fit = Fit::Scene);

  /// For a picture of this aspect, width / height, whose scene fills the frame.
  Camera camera(double aspect, const Frame& frame) const;

  const SceneFrame& axes() const { return axes_; }
  const Viewpoint& view() const { return view_; }
  const Cutaway& cut() const { return cut_; }

 private:
  void fit_to(const SceneData& scene, const SceneData& model, const RenderOptions& options);

  CameraOptions options_;
  SceneFrame axes_;
  Viewpoint view_;
  Cutaway cut_;
  std::vector<Eigen::Vector3f> fitted_;  // a sample of the points that must be in the picture
  std::optional<Camera> fixed_;
  std::optional<Eigen::Vector3d> focal_;
};

/// [deg] The azimuth of a view, as CameraOptions::azimuth has it.
double azimuth(const Viewpoint& view, const SceneFrame& frame);

}  // namespace planescope::draw
