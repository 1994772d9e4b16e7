// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planescope/patches.hpp"

namespace planescope {

/// A patch as points near its border see it: a disc of its area, on its plane.
struct PatchDisc {
  Eigen::Vector3f normal, center;
  float radius = 0;  ///< [m]
  float weight = 1;  ///< [1] of the distance above the plane

  /// \param patch its normal and centroid give the plane.
  static PatchDisc of(const Patch& patch) {
    return {patch.normal, patch.centroid, std::sqrt(patch.area / std::numbers::pi_v<float>), 1.0f};
  }

  /// [m] weighted distance above the plane, and `along` times that beyond the rim.
  float distance(const Eigen::Vector3f& p, float along) const {
    const Eigen::Vector3f d = p - center;
    const float above = normal.dot(d);
    const float beside = (d - above * normal).norm();
    return weight * std::abs(above) + along * std::max(0.0f, beside - radius);
  }
};

}  // namespace planescope
