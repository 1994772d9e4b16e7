// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/moments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace planescope {
namespace {

// The smallest eigenvalue of a symmetric 3x3 matrix with unit trace, by the trigonometric solution
// of its characteristic polynomial (O. K. Smith, "Eigenvalues of a symmetric 3 x 3 matrix", 1961).
double smallest_eigenvalue(double xx, double xy, double xz, double yy, double yz, double zz) {
  const double mean = (xx + yy + zz) / 3;
  const double a = xx - mean, b = yy - mean, c = zz - mean;
  const double off = xy * xy + xz * xz + yz * yz;
  const double p = std::sqrt((a * a + b * b + c * c + 2 * off) / 6);
  if (p < 1e-12) return mean;
  const double determinant =
      a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz);
  const double r = std::clamp(determinant / (2 * p * p * p), -1.0, 1.0);
  return mean + 2 * p * std::cos(std::acos(r) / 3 + 2 * std::numbers::pi / 3);
}

// The eigenvector: the longest cross product of two rows of M - l I.
Eigen::Vector3d eigenvector(double xx, double xy, double xz, double yy, double yz, double zz,
                            double l) {
  const Eigen::Vector3d r0(xx - l, xy, xz), r1(xy, yy - l, yz), r2(xz, yz, zz - l);
  Eigen::Vector3d best = r0.cross(r1);
  double length = best.squaredNorm();
  for (const Eigen::Vector3d& candidate :
       {Eigen::Vector3d(r0.cross(r2)), Eigen::Vector3d(r1.cross(r2))}) {
    if (candidate.squaredNorm() > length) {
      best = candidate;
      length = candidate.squaredNorm();
    }
  }
  if (length > 1e-24) return best / std::sqrt(length);
  // Points on a line (or isotropic): any direction orthogonal to the longest row, the spread's own
  // direction.
  Eigen::Vector3d row = r0;
  for (const Eigen::Vector3d& candidate : {r1, r2}) {
    if (candidate.squaredNorm() > row.squaredNorm()) row = candidate;
  }
  return row.squaredNorm() > 1e-24 ? row.unitOrthogonal() : Eigen::Vector3d::UnitZ();
}

}  // namespace

PrincipalPlane principal_plane(const Moments& m) {
  if (m.count < 3) return {};
  const double w = m.count;
  const Eigen::Vector3d mean = m.first.cast<double>() / w;
  const double xx = m.xx / w - mean.x() * mean.x(), yy = m.yy / w - mean.y() * mean.y();
  const double zz = m.zz / w - mean.z() * mean.z(), xy = m.xy / w - mean.x() * mean.y();
  const double xz = m.xz / w - mean.x() * mean.z(), yz = m.yz / w - mean.y() * mean.z();
  const double trace = xx + yy + zz;
  if (!(trace > 1e-20)) return {};
  const double s = 1 / trace;  // unit trace: tolerances without units
  const double l =
      std::max(0.0, smallest_eigenvalue(s * xx, s * xy, s * xz, s * yy, s * yz, s * zz));
  const Eigen::Vector3d normal = eigenvector(s * xx, s * xy, s * xz, s * yy, s * yz, s * zz, l);
  return {normal.cast<float>(), static_cast<float>(std::min(l, 1.0 / 3))};
}

}  // namespace planescope
