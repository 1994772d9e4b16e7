// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

namespace planescope {

/// Exponent of PatchOptions::range_exponent for single scans: their samples lie apart in proportion
/// to the range; a little less keeps far things apart.
inline constexpr double kScanRangeExponent = 0.7;

/// What a sensor that stood at one place sees: a place of the surface, and how many points lie
/// around it.
struct Sighting {
  float range = 0;       ///< [m] from the sensor
  float neighbours = 0;  ///< points within the same radius of the place
};

/// True if the cloud can be one scan taken from `sensor`, as a tripod's laser scanner takes it: the
/// density of the points falls with the range, and hardly any direction meets two surfaces. Maps
/// fused from many places do neither.
bool is_single_scan(const PointCloud& cloud, std::span<const std::uint32_t> finite,
                    std::span<const Sighting> sightings, const Eigen::Vector3f& sensor);

/// Pearson's correlation of the logarithms of range and distance between neighbours, in [-1, 1].
double spacing_correlation(std::span<const Sighting> sightings);

/// Share of the points in directions (cells of about a degree) that hold a gap in range of more
/// than a quarter: surfaces one behind the other.
double layered_share(const PointCloud& cloud, std::span<const std::uint32_t> finite,
                     const Eigen::Vector3f& sensor);

}  // namespace planescope
