// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "planescope/options.hpp"

namespace planescope {
namespace {

// Two digits are all that a derived value deserves, and they read well in reports.
double two_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::round(value / unit) * unit;
}

}  // namespace

// The presets are two points of this scale: a table top (1.7 m across, 2.5 mm spacing) gives 7.5
// mm, 3 cm and 1 cm, a room (8 m across) 2 cm, 10 cm and about 3 cm.
Options Options::automatic(const PointCloud& cloud) {
  const CloudScale scale = measure_scale(cloud);
  const double extent = double(scale.extent.norm());
  Options options;
  // What is worth separating grows with the scene: a cup on a table, a chair in a room.
  double patch = std::clamp(extent / 60, 0.03, 0.10);
  // Voxels must meet their neighbours, so they are well above the spacing; patches need voxels.
  const double voxel = std::max(patch / 4.5, 1.5 * scale.spacing);
  patch = std::max(patch, 3.5 * voxel);
  options.patches.voxel_size = two_digits(voxel);
  options.patches.patch_size = two_digits(patch);
  options.planes.sigma = two_digits(std::clamp(std::max(patch / 3, 5 * scale.noise), 0.01, 0.2));
  options.planes.min_area = two_digits(50 * patch * patch);
  return options;
}

}  // namespace planescope
