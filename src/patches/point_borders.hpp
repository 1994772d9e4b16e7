// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/patches.hpp"

namespace planescope {

/// Borders of patches run along voxels, which hold points of both sides of a crease. A point whose
/// patch meets others at a crease goes to that one of them whose surface it lies nearest to. What
/// lies beyond a patch's rim counts three tenths of what lies above it; near ties stay. Points move
/// between adjacent patches only, and no patch loses its last ones.
/// \param cloud what `graph` was made of. \param[in,out] graph its point_patch is cut anew.
void cut_at_creases(const PointCloud& cloud, PatchGraph& graph);

}  // namespace planescope
