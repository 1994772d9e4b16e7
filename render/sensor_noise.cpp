// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sensor_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planescope::draw {

double depth_noise(const PointCloud& cloud, const Eigen::Vector3d& position,
                   const Eigen::Vector3d& forward) {
  constexpr double kStep = 0.05;   // of the depth: a contour, not noise
  constexpr double kMost = 0.004;  // [1/m] an edge of 2 cm at 2 m is still seen
  if (!cloud.organised()) return 0;
  std::vector<double> departures;
  for (std::size_t i = 1; i + 1 < cloud.size(); ++i) {
    const std::size_t column = i % cloud.width;
    if (column == 0 || column + 1 == cloud.width) continue;
    double depth[3];
    bool usable = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3f& p = cloud.positions[i + k - 1];
      depth[k] = is_finite(p) ? (p.cast<double>() - position).dot(forward) : 0;
      usable = usable && depth[k] > 0;
    }
    if (!usable) continue;
    const double departure = std::abs((1 / depth[0] + 1 / depth[2]) / 2 * depth[1] - 1);
    if (departure < kStep) departures.push_back(departure / depth[1]);
  }
  if (departures.empty()) return 0;
  const auto high = departures.begin() + static_cast<std::ptrdiff_t>(departures.size() * 19 / 20);
  std::nth_element(departures.begin(), high, departures.end());
  return std::min(*high, kMost);
}

}  // namespace planescope::draw
