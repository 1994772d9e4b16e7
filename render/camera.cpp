// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

namespace planescope::draw {
namespace {

double half_tangent(double degrees) { return std::tan(degrees * std::numbers::pi / 360); }

/// The least x, and the largest, of what is divided by depth: the directions in which points lie.
struct Bounds {
  double x_low = std::numeric_limits<double>::infinity(), x_high = -x_low;
  double y_low = x_low, y_high = -x_low;
};

Bounds directions(const std::vector<Eigen::Vector3f>& points, const Camera& camera) {
  const Eigen::Vector3d forward = camera.forward(), right = camera.right();
  Bounds bounds;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>() - camera.position;
    const double depth = std::max(p.dot(forward), 1e-3);
    bounds.x_low = std::min(bounds.x_low, p.dot(right) / depth);
    bounds.x_high = std::max(bounds.x_high, p.dot(right) / depth);
    bounds.y_low = std::min(bounds.y_low, p.dot(camera.up) / depth);
    bounds.y_high = std::max(bounds.y_high, p.dot(camera.up) / depth);
  }
  return bounds;
}

void aim(Camera& camera, const Eigen::Vector3d& direction, const Eigen::Vector3d& up) {
  const Eigen::Vector3d forward = direction.normalized();
  camera.focal = camera.position + forward;
  camera.up = level(up, forward);
}

/// One axis of fit_along(): the nearest distance at which points fit, and where then the centre is
/// at any distance.
struct Slab {
  double high = -std::numeric_limits<double>::infinity();  // max of x + t_high * back
  double low = high;                                       // max of -x + t_low * back

  void add(double x, double back, double t_low, double t_high) {
    high = std::max(high, x + t_high * back);
    low = std::max(low, -x + t_low * back);
  }
  double nearest(double t_low, double t_high) const { return (high + low) / (t_low + t_high); }
  /// The middle of what x may be when the camera stands at `back`.
  double centre(double back, double t_low, double t_high) const {
    return ((high - t_high * back) + (t_low * back - low)) / 2;
  }
};

}  // namespace

Eigen::Vector3d level(const Eigen::Vector3d& vector, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d flat = vector - vector.dot(axis) * axis;
  return flat.norm() > 1e-6 * vector.norm() ? flat.normalized() : axis.unitOrthogonal();
}

Eigen::Vector3d project(const Camera& camera, double aspect, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = point - camera.position;
  const double depth = p.dot(camera.forward());
  const double scale = camera.parallel() ? 2 / camera.parallel_height
                                         : 1 / (depth * half_tangent(camera.view_angle));
  return {p.dot(camera.right()) * scale / aspect, p.dot(camera.up) * scale, depth};
}

Camera fit_along(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& forward,
                 const Eigen::Vector3d& up, double view_angle, double aspect, const Frame& frame) {
  Camera camera;
  camera.view_angle = view_angle;
  aim(camera, forward, up);
  const Eigen::Vector3d right = camera.right(), back = -camera.forward();
  const double t = half_tangent(view_angle);
  const double t_left = -frame.left * t * aspect, t_right = frame.right * t * aspect;
  const double t_bottom = -frame.bottom * t, t_top = frame.top * t;
  Slab x, y;
  double nearest_point = -std::numeric_limits<double>::infinity();
  double depth_sum = 0;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    const double b = p.dot(back);
    x.add(p.dot(right), b, t_left, t_right);
    y.add(p.dot(camera.up), b, t_bottom, t_top);
    nearest_point = std::max(nearest_point, b);
    depth_sum += b;
  }
  // 1 cm before the nearest point even where all points are one.
  const double distance =
      std::max({x.nearest(t_left, t_right), y.nearest(t_bottom, t_top), nearest_point + 0.01});
  camera.position = x.centre(distance, t_left, t_right) * right +
                    y.centre(distance, t_bottom, t_top) * camera.up + distance * back;
  const double depth = distance - depth_sum / static_cast<double>(points.size());
  camera.focal = camera.position - depth * back;
  return camera;
}

Camera fit_parallel(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& forward,
                    const Eigen::Vector3d& up, double view_angle, double aspect,
                    const Frame& frame) {
  Camera camera;
  camera.view_angle = view_angle;
  aim(camera, forward, up);
  const Eigen::Vector3d ahead = camera.forward(), right = camera.right();
  Eigen::AlignedBox3d box;  // along right, up and ahead
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d p = point.cast<double>();
    box.extend(Eigen::Vector3d(p.dot(right), p.dot(camera.up), p.dot(ahead)));
  }
  const Eigen::Vector3d size = box.sizes(), middle = box.center();
  camera.parallel_height = std::max({2 * size.y() / (frame.top - frame.bottom),
                                     2 * size.x() / (frame.right - frame.left) / aspect, 1e-3});
  const double x = middle.x() - (frame.left + frame.right) / 4 * camera.parallel_height * aspect;
  const double y = middle.y() - (frame.bottom + frame.top) / 4 * camera.parallel_height;
  const double distance = camera.parallel_height / 2 / half_tangent(view_angle) + size.z() / 2;
  camera.focal = x * right + y * camera.up + middle.z() * ahead;
  camera.position = camera.focal - distance * ahead;
  return camera;
}

double pixels_per_metre(const Camera& camera, double height, double depth) {
  return camera.parallel() ? height / camera.parallel_height
                           : height / (2 * half_tangent(camera.view_angle) * depth);
}

Camera adjusted(Camera camera, const std::optional<Eigen::Vector3d>& focal, double zoom,
                double roll) {
  if (focal) {
    camera.position += *focal - camera.focal;
    camera.focal = *focal;
  }
  if (zoom != 1) {  // what is not asked for changes no digit
    camera.parallel_height /= zoom;
    camera.view_angle =
        2 * std::atan(half_tangent(camera.view_angle) / zoom) * 180 / std::numbers::pi;
  }
  if (roll != 0)
    camera.up = Eigen::AngleAxisd(roll * std::numbers::pi / 180, camera.forward()) * camera.up;
  return camera;
}

Camera fit_from(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& position,
                const Eigen::Vector3d& up, double aspect, const Frame& frame) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) mean += p.cast<double>();
  mean /= static_cast<double>(points.size());
  Camera camera;
  camera.position = position;
  const Eigen::Vector3d ahead = mean - position;
  aim(camera, ahead.norm() > 1e-6 ? ahead : Eigen::Vector3d(up.unitOrthogonal()), up);
  Bounds seen;
  for (int turn = 0; turn < 4; ++turn) {  // towards the middle of what is seen; converges fast
    seen = directions(points, camera);
    const double x = std::tan((std::atan(seen.x_low) + std::atan(seen.x_high)) / 2);
    const double y = std::tan((std::atan(seen.y_low) + std::atan(seen.y_high)) / 2);
    aim(camera, camera.forward() + x * camera.right() + y * camera.up, up);
  }
  seen = directions(points, camera);
  const double t = std::max({seen.x_high / frame.right / aspect, seen.x_low / frame.left / aspect,
                             seen.y_high / frame.top, seen.y_low / frame.bottom, 1e-3});
  camera.view_angle = std::min(2 * std::atan(t) * 180 / std::numbers::pi, 120.0);
  camera.focal = camera.position + ahead.norm() * camera.forward();
  return camera;
}

}  // namespace planescope::draw
