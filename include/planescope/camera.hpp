// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Geometry>

/// \file The camera as a plain value, and its JSON: a picture's camera can be kept, and used again.
namespace planescope {

/// A camera: perspective, or parallel where `parallel_height` is set.
struct Camera {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d focal = Eigen::Vector3d::UnitZ();    ///< [m] what it looks at
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();       ///< unit, orthogonal to the view
  double view_angle = 30;      ///< [deg] vertical, of the whole picture; perspective only
  double parallel_height = 0;  ///< [m] height of what a parallel projection shows; 0: perspective

  Eigen::Vector3d forward() const { return (focal - position).normalized(); }
  Eigen::Vector3d right() const { return forward().cross(up).normalized(); }
  bool parallel() const { return parallel_height > 0; }
  /// Where lines of sight meet: the position or, of a parallel projection, a place so far back that
  /// they are parallel to a millionth.
  Eigen::Vector3d eye() const { return parallel() ? position - 1e6 * forward() : position; }
};

/// The camera as JSON: `position`, `focal`, `up` (three numbers each), `view_angle` [deg], and
/// `parallel_height` [m] where the projection is parallel. Numbers survive the round trip.
std::string camera_json(const Camera& camera);

/// \param name of where the text is from, for messages.
/// \throws Error{Kind::Input} it is no such JSON, or no camera: position and focal are one, up is
/// along the view, the angle is not within 0.1 to 170 degrees. `up` is made orthogonal to the view.
Camera parse_camera(const std::string& json, const std::string& name);

/// \throws Error{Kind::Input} the file cannot be read, or as above.
Camera read_camera(const std::filesystem::path& file);

/// Writes the file whole or not at all. \throws Error{Kind::Input} it cannot be written.
void write_camera(const Camera& camera, const std::filesystem::path& file);

}  // namespace planescope
