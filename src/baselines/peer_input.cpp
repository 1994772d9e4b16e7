// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/peer_input.hpp"

#include <algorithm>
#include <numeric>

#include "planescope/error.hpp"

namespace planescope {

std::vector<std::uint32_t> finite_points(const PointCloud& cloud) {
  std::vector<std::uint32_t> finite;
  finite.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (is_finite(cloud.positions[i])) finite.push_back(static_cast<std::uint32_t>(i));
  if (finite.empty())
    throw Error(Error::Kind::Input,
                "the cloud has no finite point: a peer needs at least one; check the file's x y z");
  return finite;
}

void check_extent(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                  double cell_size) {
  Eigen::Vector3f low = cloud.positions[finite.front()], high = low;
  for (const std::uint32_t i : finite) {
    low = low.cwiseMin(cloud.positions[i]);
    high = high.cwiseMax(cloud.positions[i]);
  }
  const double cells = (high.cast<double>() - low.cast<double>()).maxCoeff() / cell_size;
  if (cells > 2097148.0)  // a few less, so that a cell and its neighbours fit in 21 bits
    throw Error(Error::Kind::Computation,
                "the cloud spans more than 2^21 voxels along an axis: expected outliers to be "
                "removed; enlarge voxel_size or crop the cloud");
}

std::uint32_t rank_labels(std::vector<std::uint32_t>& labels) {
  std::vector<std::uint64_t> count;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint32_t label = labels[i];
    if (label >= count.size()) {
      count.resize(label + std::size_t{1}, 0);
      first.resize(label + std::size_t{1}, labels.size());
    }
    if (count[label]++ == 0) first[label] = i;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t label = 1; label < count.size(); ++label)
    if (count[label] > 0) order.push_back(label);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return count[a] != count[b] ? count[a] > count[b] : first[a] < first[b];
  });
  std::vector<std::uint32_t> rank(count.size(), kNoSegment);
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<std::uint32_t>(i + 1);
  for (std::uint32_t& label : labels) label = rank[label];
  return static_cast<std::uint32_t>(order.size());
}

double Lap::operator()() {
  const auto now = std::chrono::steady_clock::now();
  const double ms = std::chrono::duration<double, std::milli>(now - start_).count();
  start_ = now;
  return ms;
}

}  // namespace planescope
