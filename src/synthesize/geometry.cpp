// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace planescope::synthesis {
namespace {

constexpr double kTouch = 1e-9;  // [m] contact, up to rounding

Box3d bounds_of(const Isometry3d& pose, const Vector3d& half) {
  const Vector3d reach = pose.linear().cwiseAbs() * half;
  return {pose.translation() - reach, pose.translation() + reach};
}

// Clips [t0, t1] of p + t d to |x_axis| <= half; false where nothing is left.
bool clip_slab(double p, double d, double half, double& t0, double& t1) {
  if (std::abs(d) < 1e-12) return std::abs(p) < half - kTouch;
  const double enter = (-half - p) / d, leave = (half - p) / d;
  t0 = std::max(t0, std::min(enter, leave));
  t1 = std::min(t1, std::max(enter, leave));
  return t1 > t0 + 1e-6;
}

double nearest_squared(const Vector3d& p, const Vector3d& d, double t0, double t1) {
  const double length = d.squaredNorm();
  const double t = length > 0 ? std::clamp(-p.dot(d) / length, t0, t1) : t0;
  return (p + t * d).squaredNorm();
}

}  // namespace

bool Solid::contains(const Vector3d& p, double margin) const {
  const Vector3d local = pose.linear().transpose() * (p - pose.translation());
  switch (shape) {
    case SolidShape::Box:
      return (local.cwiseAbs().array() <= half.array() + margin).all();
    case SolidShape::Sphere:
      return local.norm() <= half.x() + margin;
    case SolidShape::Cylinder:
      return std::abs(local.z()) <= half.z() + margin &&
             local.head<2>().norm() <= half.x() + margin;
  }
  return false;
}

bool Solid::blocks(const Vector3d& p, const Vector3d& q) const {
  Vector3d from = pose.linear().transpose() * (p - pose.translation());
  Vector3d along = pose.linear().transpose() * (q - p);
  double t0 = 0, t1 = 1;
  if (shape == SolidShape::Box) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!clip_slab(from[axis], along[axis], half[axis], t0, t1)) return false;
    }
    return true;
  }
  if (shape == SolidShape::Cylinder) {
    if (!clip_slab(from.z(), along.z(), half.z(), t0, t1)) return false;
    from.z() = along.z() = 0;
  }
  const double radius = half.x() - kTouch;
  return nearest_squared(from, along, t0, t1) < radius * radius;
}

Box3d Solid::bounds() const { return bounds_of(pose, half); }

bool boxes_collide(const Solid& a, const Solid& b, double margin) {
  const Eigen::Matrix3d turn = a.pose.linear().transpose() * b.pose.linear();
  const Vector3d apart =
      a.pose.linear().transpose() * (b.pose.translation() - a.pose.translation());
  const Vector3d grown = a.half.array() + margin;
  const auto separates = [&](const Vector3d& axis) {  // given in a's frame
    if (axis.squaredNorm() < 1e-12) return false;     // the cross product of parallel edges
    const double reach =
        axis.cwiseAbs().dot(grown) + (turn.transpose() * axis).cwiseAbs().dot(b.half);
    return std::abs(axis.dot(apart)) > reach;
  };
  for (int i = 0; i < 3; ++i) {
    if (separates(Vector3d::Unit(i)) || separates(turn.col(i))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (separates(Vector3d::Unit(i).cross(turn.col(j)))) return false;
    }
  }
  return true;
}

double SurfaceGeometry::area() const {
  using std::numbers::pi;
  switch (shape) {
    case SurfaceShape::Rectangle:
      return 4 * a * b;
    case SurfaceShape::Disc:
      return pi * a * a;
    case SurfaceShape::Sphere:
      return 4 * pi * a * a;
    case SurfaceShape::CylinderSide:
      return 4 * pi * a * b;
  }
  return 0;
}

Box3d SurfaceGeometry::bounds() const {
  switch (shape) {
    case SurfaceShape::Rectangle:
      return bounds_of(pose, {a, b, 0});
    case SurfaceShape::Disc:
      return bounds_of(pose, {a, a, 0});
    case SurfaceShape::Sphere:
      return bounds_of(pose, {a, a, a});
    case SurfaceShape::CylinderSide:
      return bounds_of(pose, {a, a, b});
  }
  return {};
}

SurfacePoint SurfaceGeometry::sample(double u, double v) const {
  const double angle = 2 * std::numbers::pi * u;
  switch (shape) {
    case SurfaceShape::Rectangle:
      return describe({(2 * u - 1) * a, (2 * v - 1) * b, 0});
    case SurfaceShape::Disc: {
      const double r = a * std::sqrt(v);
      return describe({r * std::cos(angle), r * std::sin(angle), 0});
    }
    case SurfaceShape::Sphere: {  // Archimedes: equal heights, equal areas
      const double z = 2 * v - 1, r = a * std::sqrt(std::max(0.0, 1 - z * z));
      return describe({r * std::cos(angle), r * std::sin(angle), a * z});
    }
    case SurfaceShape::CylinderSide:
      return describe({a * std::cos(angle), a * std::sin(angle), (2 * v - 1) * b});
  }
  return {};
}

SurfacePoint SurfaceGeometry::at(const Vector3d& position) const {
  Vector3d local = pose.linear().transpose() * (position - pose.translation());
  if (planar()) local.z() = 0;
  return describe(local);
}

SurfacePoint SurfaceGeometry::describe(const Vector3d& local) const {
  SurfacePoint point;
  point.position = pose * local;
  if (planar()) {
    point.normal = normal();
    point.texture = local.head<2>();
    return point;
  }
  const Vector3d outwards =
      shape == SurfaceShape::Sphere ? local : Vector3d(local.x(), local.y(), 0);
  point.normal = pose.linear() * outwards.normalized();
  point.texture = {std::atan2(local.y(), local.x()) * a, local.z()};
  return point;
}

double SurfaceGeometry::intersect(const Ray& ray) const {
  const Vector3d apart = ray.origin - pose.translation();
  if (planar()) {
    const double along_normal = normal().dot(ray.direction), height = normal().dot(apart);
    if (along_normal >= 0 || height <= 0) return kNoHit;
    const double t = -height / along_normal;
    const Vector3d on_plane = apart + t * ray.direction;
    const double x = pose.linear().col(0).dot(on_plane), y = pose.linear().col(1).dot(on_plane);
    const bool inside = shape == SurfaceShape::Rectangle ? std::abs(x) <= a && std::abs(y) <= b
                                                         : x * x + y * y <= a * a;
    return inside ? t : kNoHit;
  }
  const Vector3d from = pose.linear().transpose() * apart;
  const Vector3d along = pose.linear().transpose() * ray.direction;
  // |from + t along|^2 = a^2 in three (sphere) or two (cylinder) dimensions; the nearer root.
  const Eigen::Index n = shape == SurfaceShape::Sphere ? 3 : 2;
  const double p = along.head(n).squaredNorm(), q = from.head(n).dot(along.head(n));
  const double root = q * q - p * (from.head(n).squaredNorm() - a * a);
  if (p < 1e-18 || root < 0) return kNoHit;
  const double t = (-q - std::sqrt(root)) / p;
  const bool on = n == 3 || std::abs(from.z() + t * along.z()) <= b;
  return t > 0 && on ? t : kNoHit;
}

}  // namespace planescope::synthesis
