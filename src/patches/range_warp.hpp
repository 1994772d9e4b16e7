// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

namespace planescope {

/// Pulls the far points of a single scan towards its sensor, so that a regular grid over the warped
/// points has cells that grow with the range r, as the distance of a scan's samples does:
/// p' = s + (p - s) (r0 / r)^e, with r0 the median range. At range r a cell of edge R is R (r /
/// r0)^e wide across the ray and 1 / (1 - e) times that along it, where a depth camera is worst.
/// Unlike the (x / z, y / z, log z) of PCL's single camera transform it has no pole and takes scans
/// all around. The exponent 0 is the identity.
class RangeWarp {
 public:
  RangeWarp() = default;  ///< the identity

  /// \param exponent e, in [0, 1). \param sensor s [m].
  RangeWarp(const PointCloud& cloud, double exponent, const Eigen::Vector3f& sensor);

  bool identity() const { return exponent_ == 0; }
  Eigen::Vector3f apply(const Eigen::Vector3f& p) const;
  Eigen::Vector3f invert(const Eigen::Vector3f& warped) const;

  /// (r / r0)^e: how much wider a cell is at p than at the median range.
  float scale(const Eigen::Vector3f& p) const;

  /// Area [m^2] of a plane with the given unit normal at p that meets `cells` cells of edge `size`:
  /// a plane of area A' meets A' (|nx| + |ny| + |nz|) / size^2 of them where the grid is regular.
  float area(const Eigen::Vector3f& p, const Eigen::Vector3f& normal, float cells,
             float size) const;

 private:
  float exponent_ = 0;
  float middle_ = 1;  // r0 [m]
  Eigen::Vector3f sensor_ = Eigen::Vector3f::Zero();
};

}  // namespace planescope
