// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/surfel_normals.hpp"

#include <cmath>

namespace planescope {

void take_surfel_normals(const PointCloud& cloud, const VoxelGrid& grid,
                         std::vector<Eigen::Vector3f>& normals) {
  constexpr float kAgreed = 0.5f;  // length of the mean normal: of two surfels, 120 degrees apart
  std::vector<Eigen::Vector3f> sums(normals.size(), Eigen::Vector3f::Zero());
  std::vector<float> weights(normals.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t v = grid.point_voxel[i];
    if (v == kNoVoxel || !is_finite(cloud.normals[i]) || !std::isfinite(cloud.radii[i])) continue;
    // Relative to the voxel: squares of radii in any unit are neither 0 nor infinite.
    const float r = cloud.radii[i] / grid.size, weight = r * r;
    sums[v] += weight * cloud.normals[i];
    weights[v] += weight;
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const float length = sums[v].norm();
    if (length > 0 && std::isfinite(length) && length >= kAgreed * weights[v]) {
      normals[v] = sums[v] / length;
    }
  }
}

}  // namespace planescope
