// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_order.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <Eigen/Geometry>

namespace planescope::draw {
namespace {

using Polygons = std::vector<FlatPolygon>;

double signed_distance(const FlatPolygon& plane, const Eigen::Vector3d& point) {
  return plane.normal.dot(point) - plane.distance;
}

/// Twice the area, which is enough to compare by.
double area(const FlatPolygon& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.corners.size(); ++i)
    sum += (polygon.corners[i - 1] - polygon.corners[0])
               .cross(polygon.corners[i] - polygon.corners[0]);
  return sum.norm();
}

/// A set of polygons in the plane of one of them, behind it and before it, as the eye sees it.
struct Sides {
  Polygons behind, in, before;
};

/// The parts of a polygon whose corners lie on both sides of a plane: Sutherland and Hodgman's
/// clipping, to either side at once.
std::pair<FlatPolygon, FlatPolygon> cut(const FlatPolygon& polygon,
                                        const std::vector<double>& distances, double tolerance) {
  std::pair<FlatPolygon, FlatPolygon> halves{polygon, polygon};
  auto& [below, above] = halves;
  below.corners.clear();
  above.corners.clear();
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const std::size_t next = (i + 1) % distances.size();
    const double here = distances[i], there = distances[next];
    if (here <= tolerance) below.corners.push_back(polygon.corners[i]);
    if (here >= -tolerance) above.corners.push_back(polygon.corners[i]);
    if ((here < -tolerance && there > tolerance) || (here > tolerance && there < -tolerance)) {
      const Eigen::Vector3d crossing =
          polygon.corners[i] + here / (here - there) * (polygon.corners[next] - polygon.corners[i]);
      below.corners.push_back(crossing);
      above.corners.push_back(crossing);
    }
  }
  return halves;
}

/// Puts a polygon, or its two parts, where it lies. `side`: 1 if the eye is on the normal's side
/// of the plane, else -1.
void sort_in(FlatPolygon polygon, const FlatPolygon& plane, double side, double tolerance,
             Sides& sides) {
  std::vector<double> distances;
  for (const Eigen::Vector3d& corner : polygon.corners)
    distances.push_back(side * signed_distance(plane, corner));
  const auto [low, high] = std::minmax_element(distances.begin(), distances.end());
  if (*low >= -tolerance && *high <= tolerance) {
    sides.in.push_back(std::move(polygon));
  } else if (*high <= tolerance) {
    sides.behind.push_back(std::move(polygon));
  } else if (*low >= -tolerance) {
    sides.before.push_back(std::move(polygon));
  } else {
    auto [below, above] = cut(polygon, distances, tolerance);
    sides.behind.push_back(std::move(below));
    sides.before.push_back(std::move(above));
  }
}

Sides partition(Polygons polygons, const Eigen::Vector3d& eye, double tolerance) {
  const FlatPolygon plane = *std::max_element(
      polygons.begin(), polygons.end(),
      [](const FlatPolygon& a, const FlatPolygon& b) { return area(a) < area(b); });
  const double side = signed_distance(plane, eye) < 0 ? -1 : 1;
  Sides sides;
  for (FlatPolygon& polygon : polygons) {
    // Whatever its corners' rounding, the plane's own polygon lies in it: the recursion ends.
    const bool own = polygon.source == plane.source && polygon.corners == plane.corners;
    if (own) {
      sides.in.push_back(std::move(polygon));
    } else {
      sort_in(std::move(polygon), plane, side, tolerance, sides);
    }
  }
  return sides;
}

}  // namespace

Polygons painters_order(Polygons polygons, const Eigen::Vector3d& eye, double tolerance) {
  struct Task {
    Polygons polygons;
    bool sorted;
  };
  // What is on top is farthest; a stack of our own, for the tree may be as deep as there are
  // planes.
  std::vector<Task> tasks;
  tasks.push_back({std::move(polygons), false});
  Polygons ordered;
  while (!tasks.empty()) {
    Task task = std::move(tasks.back());
    tasks.pop_back();
    if (task.sorted || task.polygons.size() < 2) {
      std::move(task.polygons.begin(), task.polygons.end(), std::back_inserter(ordered));
      continue;
    }
    Sides sides = partition(std::move(task.polygons), eye, tolerance);
    tasks.push_back({std::move(sides.before), false});
    tasks.push_back({std::move(sides.in), true});
    tasks.push_back({std::move(sides.behind), false});
  }
  return ordered;
}

}  // namespace planescope::draw
