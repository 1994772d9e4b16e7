// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "io/assemble.hpp"

namespace planescope::io {
namespace {

constexpr std::size_t kGroups = 64, kNeighbours = 16;
constexpr double kFar = 1000;  ///< [m] float still tells 0.06 mm apart there

using Axes = std::array<std::vector<double>, 3>;

/// Adds the finite points of a block to the sample.
void add_finite(const std::vector<Column>& columns, const Selection& selection, std::size_t count,
                Axes& sample) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Column& column = columns[*selection.role[axis]];
      const std::byte* at = column.data + i * column.stride;
      point[axis] = column.type == Scalar::F64 ? load<double>(at, column.swapped)
                                               : double{load<float>(at, column.swapped)};
    }
    if (!std::all_of(point.begin(), point.end(), [](double c) { return std::isfinite(c); })) {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) sample[axis].push_back(point[axis]);
  }
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Eigen::Vector3d choose_origin(const PointSource& source, const Selection& selection,
                              std::size_t points) {
  Scratch scratch;
  Axes sample;
  for (std::size_t group = 0; group < kGroups; ++group) {
    const std::size_t first = points / kGroups * group;
    const std::size_t count = std::min(kNeighbours, points - first);
    add_finite(source.block(first, count, scratch), selection, count, sample);
  }
  // A view with hardly a return: go by the first block that has one.
  const std::size_t step = source.block_points();
  for (std::size_t first = 0; sample[0].empty() && first < points; first += step) {
    const std::size_t count = std::min(step, points - first);
    add_finite(source.block(first, count, scratch), selection, count, sample);
  }
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  if (sample[0].empty()) return origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin[static_cast<Eigen::Index>(axis)] = median(sample[axis]);
  }
  if ((origin.array().abs() <= kFar).all()) return Eigen::Vector3d::Zero();
  return origin.array().round();
}

}  // namespace planescope::io
