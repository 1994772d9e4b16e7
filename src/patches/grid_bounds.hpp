// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

/// \file Where a cloud lies, as a voxel grid needs to know it.
namespace planescope {

/// The box of the finite points; of a cloud with strays, of all but those.
struct GridBounds {
  Eigen::Vector3f lower, upper;  ///< [m]
  std::size_t strays = 0;        ///< finite points outside

  double extent() const { return (upper - lower).cast<double>().maxCoeff(); }
  bool takes(const Eigen::Vector3f& p) const {
    return is_finite(p) && (strays == 0 || ((p.array() >= lower.array()).all() &&
                                            (p.array() <= upper.array()).all()));
  }
};

/// The box of all finite points where no side of it is longer than `longest` [m]. Else the few
/// points, at most one in a hundred, that lie further from the others (their 1st to 99th percentile
/// along each axis, of a fixed sample) than those are from each other, and a metre, are strays:
/// what a scanner writes where it saw nothing. \throws Error{Kind::Input} no finite point.
GridBounds find_grid_bounds(const PointCloud& cloud, double longest);

}  // namespace planescope
