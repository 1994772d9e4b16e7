// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

/// \file The camera as a plain value, and how it is fitted to a scene.
namespace planescope::draw {

/// A perspective camera.
struct Camera {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d focal = Eigen::Vector3d::UnitZ();    ///< [m] what it looks at
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();       ///< unit, orthogonal to the view
  double view_angle = 30;                              ///< [deg] vertical, of the whole picture

  Eigen::Vector3d forward() const { return (focal - position).normalized(); }
  Eigen::Vector3d right() const { return forward().cross(up).normalized(); }
};

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

/// The camera at `position`, upright with `up`, turned and opened so that all points fit into the
/// frame; the angle ends at 120 degrees, beyond which pictures are distorted.
Camera fit_from(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& position,
                const Eigen::Vector3d& up, double aspect, const Frame& frame);

/// `vector` without its part along the unit vector `axis`, unit; if nothing is left, any unit
/// vector that is orthogonal to the axis.
Eigen::Vector3d level(const Eigen::Vector3d& vector, const Eigen::Vector3d& axis);

}  // namespace planescope::draw
