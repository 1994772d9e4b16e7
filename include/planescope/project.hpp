// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/cloud.hpp"

/// \file The paper's protocol of evaluation: a segmented map, seen by a camera, against the labels
/// of that camera's image.
namespace planescope {

/// A pinhole camera: x right, y down, z forward. A point (x, y, z) of its frame is seen at column
/// fx x / z + cx, row fy y / z + cy; whole numbers are the centres of pixels.
struct PinholeCamera {
  std::uint32_t width = 640, height = 480;                 ///< [pixel]
  double fx = 525, fy = 525, cx = 319.5, cy = 239.5;       ///< [pixel]
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< camera to world [m]
};

/// The labels of a map as an image, row by row: in each pixel the nearest point wins (of equals the
/// first), also one without a label; kNoSegment where there is none. World coordinates are the
/// cloud's origin + position.
/// \param labels one a point; \param radius [pixel] a point covers the square of 2 radius + 1
/// pixels around its own: closes the holes between the points of a sparse map.
/// \throws Error{Kind::Input} another number of labels than points.
/// \throws Error{Kind::Usage} a focal length that is not positive, no pixel, more than 2^28 of
/// them, or a radius of more than 64.
std::vector<std::uint32_t> project_labels(const PointCloud& cloud,
                                          std::span<const std::uint32_t> labels,
                                          const PinholeCamera& camera, std::uint32_t radius = 0);

}  // namespace planescope
