// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hull.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace planescope::draw {
namespace {

/// Twice the signed area of the triangle a, b, c; positive if it turns left at b.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  return ab.x() * ac.y() - ab.y() * ac.x();
}

/// Walks over sorted points and keeps those that turn left; the last one begins the next chain.
template <typename Iterator>
void add_chain(Iterator begin, Iterator end, std::vector<Eigen::Vector2d>& hull) {
  const std::size_t start = hull.size();
  for (Iterator p = begin; p != end; ++p) {
    while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0)
      hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();
}

}  // namespace

std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;
  add_chain(points.begin(), points.end(), hull);
  add_chain(points.rbegin(), points.rend(), hull);
  return hull;
}

double polygon_area(const std::vector<Eigen::Vector2d>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

std::pair<Eigen::Vector3d, Eigen::Vector3d> plane_axes(const Eigen::Vector3d& normal) {
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d u = normal.cross(Eigen::Vector3d::Unit(least)).normalized();
  return {u, normal.cross(u)};
}

}  // namespace planescope::draw
