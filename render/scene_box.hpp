// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "planescope/result.hpp"

namespace planescope::draw {

/// Where there may be something to see: twenty times as far around the segments as those reach.
/// Points beyond are strays; one of them a million times further away takes all depth from the
/// rest.
class SceneBox {
 public:
  explicit SceneBox(const Result& result);

  /// Every finite point, where nothing is segmented.
  bool holds(const Eigen::Vector3f& p) const {
    return is_finite(p) && (box_.isEmpty() || box_.contains(p.cast<double>()));
  }

 private:
  Eigen::AlignedBox3d box_;
};

}  // namespace planescope::draw
