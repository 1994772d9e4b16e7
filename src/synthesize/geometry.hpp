// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include <Eigen/Geometry>

/// \file The shapes that a synthetic scene is made of: solids, which hide things, and their
/// surfaces, which are sampled and seen. All lengths are metres.
namespace planescope::synthesis {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Box3d = Eigen::AlignedBox3d;

/// Points origin + t * direction, t >= 0; the direction need not be of unit length.
struct Ray {
  Vector3d origin, direction;
};

inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

enum class SolidShape { Box, Sphere, Cylinder };

/// A solid, centred on its own frame; a cylinder's axis is z.
struct Solid {
  SolidShape shape = SolidShape::Box;
  Isometry3d pose = Isometry3d::Identity();  ///< own frame to world
  Vector3d half = Vector3d::Zero();  ///< half extents; sphere (r, r, r); cylinder (r, r, height/2)

  /// True if `p` is inside, or no farther than `margin` outside (for a box: along its axes).
  bool contains(const Vector3d& p, double margin) const;

  /// True if more than an instant of the segment from `p` to `q` is inside: touching is not
  /// blocking.
  bool blocks(const Vector3d& p, const Vector3d& q) const;

  Box3d bounds() const;
};

/// True if the boxes around two solids come nearer than `margin` (separating axes; Gottschalk et
/// al., SIGGRAPH 1996).
bool boxes_collide(const Solid& a, const Solid& b, double margin);

enum class SurfaceShape { Rectangle, Disc, Sphere, CylinderSide };

/// A point of a surface, with what is needed to colour it.
struct SurfacePoint {
  Vector3d position, normal;  ///< world; the normal points away from the solid
  Vector2d texture;           ///< [m] along the surface
};

/// A surface in its own frame: rectangle and disc lie in z = 0 and face +z; sphere and cylinder are
/// centred, the cylinder along z, and face outwards.
struct SurfaceGeometry {
  SurfaceShape shape = SurfaceShape::Rectangle;
  Isometry3d pose = Isometry3d::Identity();  ///< own frame to world
  double a = 0;  ///< half width of a rectangle (x); radius of the others
  double b = 0;  ///< half height of a rectangle (y) or of a cylinder (z)

  bool planar() const { return shape == SurfaceShape::Rectangle || shape == SurfaceShape::Disc; }
  Vector3d normal() const { return pose.linear().col(2); }  ///< of a planar one
  double area() const;                                      ///< [m^2]
  Box3d bounds() const;

  /// Maps the unit square onto the surface, equal areas to equal areas.
  SurfacePoint sample(double u, double v) const;

  /// The surface's point nearest to `position`, which lies on it up to rounding.
  SurfacePoint at(const Vector3d& position) const;

  /// Smallest t > 0 at which the ray meets the surface from its outer side, or kNoHit.
  double intersect(const Ray& ray) const;

 private:
  SurfacePoint describe(const Vector3d& local) const;
};

}  // namespace planescope::synthesis
