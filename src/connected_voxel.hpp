// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/cloud.hpp"

namespace planescope {

/// The smallest voxel, from `smallest` up, in which the cloud's surfaces hang together:
/// CloudScale::connected_voxel [m]. Organised clouds: `smallest`.
/// \param median_range as in CloudScale: 0 for a map, else the voxels grow with the range.
double find_connected_voxel(const PointCloud& cloud, double smallest, double median_range);

}  // namespace planescope
