// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/voxel_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace planescope {
namespace {

/// 21 bits an axis: check_extent() has seen to it that cells fit, with room for a neighbour.
std::uint64_t key_of(const Eigen::Vector3f& point, const Eigen::Vector3d& origin, double size) {
  const Eigen::Vector3d cell = ((point.cast<double>() - origin) / size).array().floor() + 1.0;
  const auto bits = [](double v) { return static_cast<std::uint64_t>(v) & 0x1fffff; };
  return bits(cell.x()) << 42 | bits(cell.y()) << 21 | bits(cell.z());
}

/// What to add to a key for the 13 of the 26 neighbours that come later: each pair is met once.
std::array<std::uint64_t, 13> later_neighbours() {
  std::array<std::uint64_t, 13> steps{};
  std::size_t n = 0;
  for (std::int64_t x = -1; x <= 1; ++x)
    for (std::int64_t y = -1; y <= 1; ++y)
      for (std::int64_t z = -1; z <= 1; ++z) {
        const std::int64_t step = x * (std::int64_t{1} << 42) + y * (std::int64_t{1} << 21) + z;
        if (step > 0) steps[n++] = static_cast<std::uint64_t>(step);
      }
  return steps;
}

}  // namespace

Eigen::Vector3d octree_origin(const Eigen::Vector3f& low, const Eigen::Vector3f& high,
                              double voxel_size) {
  const Eigen::Vector3d extent = high.cast<double>() - low.cast<double>();
  const double voxels = std::max(2.0, std::ceil(extent.maxCoeff() / voxel_size));
  const double side = std::exp2(std::ceil(std::log2(voxels))) * voxel_size;
  return low.cast<double>() - 0.5 * (Eigen::Vector3d::Constant(side) - extent);
}

PatchVoxels make_voxels(std::span<const Eigen::Vector3f> points, std::span<const Rgb> colors,
                        std::span<const std::int32_t> patch, double voxel_size) {
  Eigen::Vector3f low = points.front(), high = low;
  for (const Eigen::Vector3f& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector3d origin = octree_origin(low, high, voxel_size);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (patch[i] != kNone) order.emplace_back(key_of(points[i], origin, voxel_size), i);
  std::sort(order.begin(), order.end());
  PatchVoxels voxels;
  voxels.voxel_size = voxel_size;
  for (std::size_t from = 0; from < order.size();) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), color = mean;
    std::size_t to = from;
    for (; to < order.size() && order[to].first == order[from].first; ++to) {
      const Rgb& rgb = colors[order[to].second];
      mean += points[order[to].second].cast<double>();
      color += Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
    }
    const auto count = static_cast<double>(to - from);
    voxels.keys.push_back(order[from].first);
    voxels.means.push_back((mean / count).cast<float>());
    voxels.colors.push_back((color / count).cast<float>());
    voxels.patch.push_back(static_cast<std::uint32_t>(patch[order[from].second]));
    from = to;
  }
  return voxels;
}

void measure_patches(const PatchVoxels& voxels, std::vector<Patch>& patches) {
  std::vector<Eigen::Vector3d> mean(patches.size(), Eigen::Vector3d::Zero()), color = mean;
  for (Patch& patch : patches) patch.voxel_count = 0;
  for (std::size_t v = 0; v < voxels.means.size(); ++v) {
    mean[voxels.patch[v]] += voxels.means[v].cast<double>();
    color[voxels.patch[v]] += voxels.colors[v].cast<double>();
    ++patches[voxels.patch[v]].voxel_count;
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    mean[p] /= patches[p].voxel_count;
    patches[p].centroid = mean[p].cast<float>();
    patches[p].color = (color[p] / patches[p].voxel_count).cast<float>();
  }
  std::vector<Eigen::Matrix3d> scatter(patches.size(), Eigen::Matrix3d::Zero());
  for (std::size_t v = 0; v < voxels.means.size(); ++v) {
    const Eigen::Vector3d d = voxels.means[v].cast<double>() - mean[voxels.patch[v]];
    scatter[voxels.patch[v]] += d * d.transpose();
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> pca(scatter[p], Eigen::EigenvaluesOnly);
    const double sum = pca.eigenvalues().sum();
    patches[p].curvature =
        sum > 0 ? static_cast<float>(std::max(0.0, pca.eigenvalues()[0]) / sum) : 0.0F;
    const double slant = std::max(1.0, static_cast<double>(patches[p].normal.lpNorm<1>()));
    patches[p].area =
        static_cast<float>(patches[p].voxel_count * voxels.voxel_size * voxels.voxel_size / slant);
  }
}

std::vector<Adjacency> find_borders(const PatchVoxels& voxels) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const std::uint64_t step : later_neighbours()) {
    std::size_t other = 0;  // moves along with v: keys are sorted, and so are keys + step
    for (std::size_t v = 0; v < voxels.keys.size(); ++v) {
      const std::uint64_t wanted = voxels.keys[v] + step;
      while (other < voxels.keys.size() && voxels.keys[other] < wanted) ++other;
      if (other == voxels.keys.size()) break;
      if (voxels.keys[other] == wanted && voxels.patch[other] != voxels.patch[v])
        pairs.push_back(std::minmax(voxels.patch[v], voxels.patch[other]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<Adjacency> borders;
  for (const auto& [first, second] : pairs) {
    if (borders.empty() || borders.back().first != first || borders.back().second != second)
      borders.push_back({first, second, 0});
    ++borders.back().border;
  }
  return borders;
}

}  // namespace planescope
