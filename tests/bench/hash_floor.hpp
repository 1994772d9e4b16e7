// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/cloud.hpp"

namespace planescope::bench {

/// The floor of voxelising: one pass over the points, each looked up in an open-addressing hash
/// table of voxels (prefetched a few points ahead) and given its voxel's number. No means, no
/// neighbours, one thread. \returns per point: voxel, in the order of first appearance.
std::vector<std::uint32_t> hash_pass(const PointCloud& cloud, double voxel_size);

}  // namespace planescope::bench
