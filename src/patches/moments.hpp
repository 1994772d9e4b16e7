// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace planescope {

/// Ten moments of a set of points about a reference point of their own: count, first and second
/// moments. Sums about a reference near the points keep single precision; about the world's origin
/// they would not.
struct Moments {
  float count = 0;
  Eigen::Vector3f first = Eigen::Vector3f::Zero();  ///< sum of q, q relative to the reference [m]
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  ///< sum of q q^T [m^2]

  void add(const Eigen::Vector3f& q) {
    count += 1;
    first += q;
    xx += q.x() * q.x();
    xy += q.x() * q.y();
    xz += q.x() * q.z();
    yy += q.y() * q.y();
    yz += q.y() * q.z();
    zz += q.z() * q.z();
  }

  /// Adds a set whose reference lies at `d` from ours.
  void add_shifted(const Moments& other, const Eigen::Vector3f& d) {
    const Eigen::Vector3f& s = other.first;
    const float w = other.count;
    count += w;
    first += s + w * d;
    xx += other.xx + (2 * s.x() + w * d.x()) * d.x();
    yy += other.yy + (2 * s.y() + w * d.y()) * d.y();
    zz += other.zz + (2 * s.z() + w * d.z()) * d.z();
    xy += other.xy + s.x() * d.y() + (s.y() + w * d.y()) * d.x();
    xz += other.xz + s.x() * d.z() + (s.z() + w * d.z()) * d.x();
    yz += other.yz + s.y() * d.z() + (s.z() + w * d.z()) * d.y();
  }
};

/// A plane through points by principal components.
struct PrincipalPlane {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit, sign arbitrary
  float curvature = 0;  ///< l0 / (l0 + l1 + l2), in [0, 1/3]; 0 for fewer than three points
};

/// Normal and curvature of a set of points from its moments. Fewer than three points, or points all
/// alike: +z and 0.
PrincipalPlane principal_plane(const Moments& moments);

}  // namespace planescope
