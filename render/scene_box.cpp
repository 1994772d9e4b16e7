// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene_box.hpp"

namespace planescope::draw {

SceneBox::SceneBox(const Result& result) {
  constexpr double kReach = 20, kLeast = 1;  // [1], [m]
  Eigen::AlignedBox3f seen;
  for (std::size_t i = 0; i < result.cloud.size(); ++i) {
    const Eigen::Vector3f& p = result.cloud.positions[i];
    if (result.point_label[i] != kNoSegment && is_finite(p)) seen.extend(p);
  }
  if (seen.isEmpty()) return;
  box_ = seen.cast<double>();
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kReach * box_.sizes().norm() + kLeast);
  box_ = Eigen::AlignedBox3d(box_.min() - margin, box_.max() + margin);
}

}  // namespace planescope::draw
