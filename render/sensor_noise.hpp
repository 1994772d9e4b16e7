// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "planescope/cloud.hpp"

/// \file How rough an organised view's depth is.
namespace planescope::draw {

/// The depth camera's noise relative to depth, for each metre of depth [1/m]: noise that grows with
/// z^2, as that of structured light and stereo does, is one such number, and so is the size of a
/// Kinect's depth steps. Measured as the 95th percentile, over pixels, of how far a pixel's depth
/// lies from the middle of its left and right neighbours (in inverse depth, where planes are
/// straight), over its depth; at most 0.004. 0 where the cloud is not organised.
/// \param position of the sensor, \param forward unit, its viewing direction
double depth_noise(const PointCloud& cloud, const Eigen::Vector3d& position,
                   const Eigen::Vector3d& forward);

}  // namespace planescope::draw
