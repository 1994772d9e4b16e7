// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

/// \file Convex hulls in a plane.
namespace planescope::draw {

/// The convex hull of points in the plane, counter-clockwise from the leftmost lowest one, without
/// repeated or collinear corners. Fewer than three corners: the points are one point or a line.
/// Andrew's monotone chain (Information Processing Letters 9(5), 1979): O(n log n).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

/// Area of a polygon by the shoelace formula; positive if counter-clockwise.
double polygon_area(const std::vector<Eigen::Vector2d>& corners);

/// Two unit vectors u, v that span the plane with this unit normal, u x v = normal. A function of
/// the normal alone.
std::pair<Eigen::Vector3d, Eigen::Vector3d> plane_axes(const Eigen::Vector3d& normal);

}  // namespace planescope::draw
