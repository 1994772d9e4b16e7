// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/camera.hpp"

/// \file How a camera is fitted to a scene.
namespace planescope::draw {

using planescope::Camera;

/// The part of the picture that the scene may fill, in normalised coordinates: the picture spans
/// -1 to 1, x to the right, y upwards.
struct Frame {
  double left = -0.97, right = 0.97, bottom = -0.97, top = 0.97;
};

/// Where a point is seen: x and y in normalised coordinates, z the depth along the view [m];
/// z <= 0 is behind the camera.
Eigen::Vector3d project(const Camera& camera, double aspect, const Eigen::Vector3d& point);

/// The camera that looks along `forward`, upright with `up`, from as near as all points fit into
/// the frame. Exact, by the extreme points along the normals of the frustum's four sides;
/// `aspect` is width / height.
Camera fit_along(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& forward,
                 const Eigen::Vector3d& up, double view_angle, double aspect, const Frame& frame);

/// The parallel projection along `forward`, upright with `up`, that shows all points within the
/// frame and no more. The camera stands as far off as one with this view angle would.
Camera fit_parallel(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& forward,
                    const Eigen::Vector3d& up, double view_angle, double aspect,
                    const Frame& frame);

/// The camera at `position`, upright with `up`, turned and opened so that all points fit into the
/// frame; the angle ends at 120 degrees, beyond which pictures are distorted.
Camera fit_from(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& position,
                const Eigen::Vector3d& up, double aspect, const Frame& frame);

/// [pixel] of a picture of this height that a metre takes at this depth [m].
double pixels_per_metre(const Camera& camera, double height, double depth);

/// The camera moved so that `focal` is in the middle of the picture, then opened or closed to show
/// things `zoom` times as large, then turned clockwise by `roll` [deg]: what it shows turns the
/// other way.
Camera adjusted(Camera camera, const std::optional<Eigen::Vector3d>& focal, double zoom,
                double roll);

/// `vector` without its part along the unit vector `axis`, unit; if nothing is left, any unit
/// vector that is orthogonal to the axis.
Eigen::Vector3d level(const Eigen::Vector3d& vector, const Eigen::Vector3d& axis);

}  // namespace planescope::draw
