// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "camera.hpp"
#include "planescope/cloud.hpp"
#include "splats.hpp"

/// \file Large clouds are thinned on the screen: what no pixel can show is not uploaded.
namespace planescope::draw {

/// Of the points `indices` of a cloud those that are nearest to the camera in a pixel of a picture
/// of width x height pixels, in their order. Points before the camera but outside the picture, by
/// up to `margin` of its size, are kept by the same rule; others go.
std::vector<std::uint32_t> nearest_per_pixel(const PointCloud& cloud,
                                             const std::vector<std::uint32_t>& indices,
                                             const Camera& camera, int width, int height,
                                             double margin = 0.05);

/// Of the points `indices` those whose splat is the nearest one at the middle of any pixel of a
/// picture of width x height pixels, in their order: drawn alone they make the same picture.
/// `margin`: as above. \param diameters of each of `indices` [m].
std::vector<std::uint32_t> seen_splats(const PointCloud& cloud,
                                       const std::vector<std::uint32_t>& indices,
                                       const std::vector<float>& diameters, const PointScale& scale,
                                       const Camera& camera, int width, int height,
                                       double margin = 0.05);

}  // namespace planescope::draw
