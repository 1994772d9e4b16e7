// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/patches.hpp"

namespace planescope {

/// Cuts patches at creases instead of along voxels: a point whose patch meets others at a crease
/// goes to that one of them whose surface it lies nearest to (recut_points()). No patch loses its
/// last points.
/// \param cloud what `graph` was made of. \param[in,out] graph its point_patch and the counts of
/// points are made anew.
void cut_at_creases(const PointCloud& cloud, PatchGraph& graph);

}  // namespace planescope
