// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "planescope/cloud.hpp"

/// \file What all peers share before and after PCL runs.
namespace planescope {

/// Indices of the cloud's finite points, ascending: PCL never sees the others.
/// \throws Error{Kind::Input} there is none.
std::vector<std::uint32_t> finite_points(const PointCloud& cloud);

/// \throws Error{Kind::Computation} the finite points span more than 2^21 cells along an axis.
void check_extent(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                  double cell_size);

/// Renumbers labels in place: 1 for the label with the most points, and so on; ties go to the label
/// that comes first; 0 stays 0. \returns the number of labels.
std::uint32_t rank_labels(std::vector<std::uint32_t>& labels);

/// Milliseconds since it was made or last asked.
class Lap {
 public:
  double operator()();

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace planescope
