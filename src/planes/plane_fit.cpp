// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_fit.hpp"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace planescope {
namespace {

/// Weighted moments of centroids about a point near them, in double: a difference of large squares
/// would lose the plane.
struct Moments {
  double weight = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();  ///< on the side of the previous normal
};

/// Tukey's biweight of a residual in units of the inlier distance: 1 on the plane, 0 at sigma.
double biweight(double r) {
  const double rest = std::max(0.0, 1 - r * r);
  return rest * rest;
}

Moments moments_of(const PatchIndex& index, const Bits& members, const Eigen::Vector3d& shift,
                   const Plane& previous, double sigma) {
  constexpr double kLeast = 1e-6;  // [m^2] a patch without area still has a say
  const Eigen::Vector3d side = previous.normal.cast<double>();
  Moments m;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for_each(members, [&](std::size_t i) {
    const double r = static_cast<double>(previous.signed_distance(index.centroid(i))) /
                     (sigma * static_cast<double>(index.scale(i)));
    const double w = std::max(static_cast<double>(index.area(i)), kLeast) * biweight(r);
    const Eigen::Vector3d p = index.centroid(i).cast<double>() - shift;
    const Eigen::Vector3d n = index.normal(i).cast<double>();
    const Eigen::Vector3d wp = w * p;
    m.weight += w;
    m.sum += wp;
    xx += wp.x() * p.x(), xy += wp.x() * p.y(), xz += wp.x() * p.z();
    yy += wp.y() * p.y(), yz += wp.y() * p.z(), zz += wp.z() * p.z();
    m.normals += n.dot(side) < 0 ? Eigen::Vector3d(-w * n) : Eigen::Vector3d(w * n);
  });
  m.outer << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return m;
}

Plane through(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  return {normal.cast<float>(), static_cast<float>(normal.dot(point))};
}

}  // namespace

Plane orient_plane(const PatchIndex& index, const Bits& members, const Plane& plane) {
  std::int64_t votes = 0;
  for_each(members,
           [&](std::size_t i) { votes += index.normal(i).dot(plane.normal) < 0 ? -1 : 1; });
  return votes < 0 ? Plane{-plane.normal, -plane.distance} : plane;
}

Plane fit_plane(const PatchIndex& index, const Bits& members, const Plane& previous, double sigma) {
  const auto first = std::find_if(members.begin(), members.end(), [](auto w) { return w != 0; });
  if (first == members.end()) return previous;
  const auto word = static_cast<std::size_t>(first - members.begin());
  const std::size_t any = word * 64 + static_cast<std::size_t>(std::countr_zero(*first));
  const Eigen::Vector3d shift = index.centroid(any).cast<double>();
  const Moments m = moments_of(index, members, shift, previous, sigma);
  if (!(m.weight > 0)) return previous;
  const Eigen::Vector3d mean = m.sum / m.weight;
  const Eigen::Matrix3d covariance = m.outer / m.weight - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> pca(covariance);
  const bool fixed = pca.eigenvalues()(1) > sigma * sigma;
  Eigen::Vector3d normal = fixed ? Eigen::Vector3d(pca.eigenvectors().col(0)) : m.normals;
  if (normal.norm() == 0) normal = previous.normal.cast<double>();
  if (normal.dot(previous.normal.cast<double>()) < 0) normal = -normal;
  return through(normal.normalized(), mean + shift);
}

}  // namespace planescope
