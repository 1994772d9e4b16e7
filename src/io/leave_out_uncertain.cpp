// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <sstream>

#include "planescope/error.hpp"
#include "planescope/io.hpp"

namespace planescope {
namespace {

[[noreturn]] void refuse_all(const PointCloud& cloud, double min_confidence, float highest) {
  std::ostringstream message;
  message << "none of " << cloud.size() << " points has a confidence of at least "
          << min_confidence;
  if (highest > -std::numeric_limits<float>::max()) {
    message << ", the highest is " << highest << "; ask for less";
  } else {
    message << ", because none has any; leave the minimum away";
  }
  throw Error(Error::Kind::Input, message.str());
}

}  // namespace

CertainCloud leave_out_uncertain(PointCloud cloud, double min_confidence) {
  if (!cloud.has_confidences()) {
    throw Error(Error::Kind::Input,
                "the cloud has no confidences to leave points out by; expected a field "
                "`confidence`, as surfel maps have it");
  }
  CertainCloud certain{std::move(cloud)};
  std::size_t left = 0;
  float highest = -std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < certain.cloud.size(); ++i) {
    Eigen::Vector3f& p = certain.cloud.positions[i];
    if (!is_finite(p)) continue;
    const float confidence = certain.cloud.confidences[i];
    if (confidence > highest) highest = confidence;
    if (double{confidence} >= min_confidence) {  // false for NaN
      ++left;
    } else {
      p.setConstant(std::numeric_limits<float>::quiet_NaN());
      ++certain.left_out;
    }
  }
  if (left == 0) refuse_all(certain.cloud, min_confidence, highest);
  return certain;
}

}  // namespace planescope
