// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/range_warp.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planescope {
namespace {

constexpr std::size_t kSample = 65536;  // points that give the median range
constexpr float kNearest = 1e-3f;       // [m] no sensor sees nearer; keeps the powers finite

float median_range(const PointCloud& cloud, const Eigen::Vector3f& sensor) {
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / kSample);
  std::vector<float> ranges;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (is_finite(cloud.positions[i])) ranges.push_back((cloud.positions[i] - sensor).norm());
  }
  if (ranges.empty()) return 1;
  const auto middle = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2);
  std::nth_element(ranges.begin(), middle, ranges.end());
  return std::max(*middle, kNearest);
}

}  // namespace

RangeWarp::RangeWarp(const PointCloud& cloud, double exponent, const Eigen::Vector3f& sensor)
    : exponent_(static_cast<float>(exponent)),
      middle_(median_range(cloud, sensor)),
      sensor_(sensor) {}

float RangeWarp::scale(const Eigen::Vector3f& p) const {
  if (identity()) return 1;
  return std::pow(std::max((p - sensor_).norm(), kNearest) / middle_, exponent_);
}

Eigen::Vector3f RangeWarp::apply(const Eigen::Vector3f& p) const {
  return sensor_ + (p - sensor_) / scale(p);
}

Eigen::Vector3f RangeWarp::invert(const Eigen::Vector3f& warped) const {
  const Eigen::Vector3f ray = warped - sensor_;
  // r' = r0 (r / r0)^(1 - e)
  const float ratio = std::max(ray.norm(), std::numeric_limits<float>::min()) / middle_;
  return sensor_ + ray * std::pow(ratio, exponent_ / (1 - exponent_));
}

float RangeWarp::area(const Eigen::Vector3f& p, const Eigen::Vector3f& normal, float cells,
                      float size) const {
  const float across = 1 / scale(p), along = (1 - exponent_) * across;  // the warp's Jacobian
  const Eigen::Vector3f ray =
      identity() ? Eigen::Vector3f::Zero() : Eigen::Vector3f((p - sensor_).stableNormalized());
  const Eigen::Vector3f forward = normal.dot(ray) * ray;
  const Eigen::Vector3f turned = (normal - forward) / across + forward / along;  // J^-T n
  const float length = turned.norm();
  const float warped_area = cells * size * size / (turned.lpNorm<1>() / length);
  return warped_area / (across * across * along * length);  // dA' = det J |J^-T n| dA
}

}  // namespace planescope
