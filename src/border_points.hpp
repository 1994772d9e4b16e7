// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/pipeline.hpp"

namespace planescope {

/// Cuts along surfaces instead of along voxels: a point of a patch that borders on another segment
/// goes to that one of the two patches whose surface it lies nearer to: the plane or face that the
/// patch is on, else its own plane. What lies beside a patch, rather than above it, counts a tenth;
/// ties and near ties stay. Moves points between adjacent patches only, so that segments, planes
/// and edges stand; counts of points follow. \param scene all but the labels of points. \param
/// surface the cloud that patches were made of.
void recut_borders(Segmentation& scene, const PointCloud& surface);

}  // namespace planescope
