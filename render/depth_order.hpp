// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

/// \file Painter's order of translucent polygons: they are blended from the farthest to the
/// nearest, once, where depth peeling would draw all of them once for every layer.
namespace planescope::draw {

/// A flat convex polygon.
struct FlatPolygon {
  std::vector<Eigen::Vector3d> corners;  ///< [m] in order around it; at least three
  Eigen::Vector3d normal;                ///< unit
  double distance = 0;                   ///< [m] normal . x of its plane
  std::size_t source = 0;  ///< what it is a piece of: kept, and otherwise not looked at
};

/// The polygons, cut where they would hide each other in turn, such that none is hidden from `eye`
/// by one before it: a traversal of the binary space partition of Fuchs, Kedem and Naylor (SIGGRAPH
/// 1980) whose planes are the polygons' own, the largest polygon's first. Polygons of one plane
/// stay in their order. `tolerance` [m]: corners this near to a plane lie in it.
std::vector<FlatPolygon> painters_order(std::vector<FlatPolygon> polygons,
                                        const Eigen::Vector3d& eye, double tolerance = 1e-6);

}  // namespace planescope::draw
