// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>
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

  /// [m] weighted distance above the plane, and `along` times that beyond the rim; where that is
  /// not less than `limit`, some number that is not.
  float distance(const Eigen::Vector3f& p, float along,
                 float limit = std::numeric_limits<float>::infinity()) const {
    const Eigen::Vector3f d = p - center;
    const float above = normal.dot(d);
    const float weighted = weight * std::abs(above);
    if (weighted >= limit) return weighted;
    const float beside = d.squaredNorm() - above * above;  // squared
    return beside > radius * radius ? weighted + along * (std::sqrt(beside) - radius) : weighted;
  }
};

}  // namespace planescope
