// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "camera.hpp"
#include "planescope/cloud.hpp"

/// \file Large clouds are thinned on the screen: what no pixel can show is not uploaded.
namespace planescope::draw {

/// From this many points on it pays.
inline constexpr std::size_t kThinningPoints = 3'000'000;

/// Of the points `indices` of a cloud those that are nearest to the camera in a pixel of a picture
/// of width x height pixels, in their order. Points before the camera but outside the picture, by
/// up to `margin` of its size, are kept by the same rule; others go.
std::vector<std::uint32_t> nearest_per_pixel(const PointCloud& cloud,
                                             const std::vector<std::uint32_t>& indices,
                                             const Camera& camera, int width, int height,
                                             double margin = 0.05);

}  // namespace planescope::draw
