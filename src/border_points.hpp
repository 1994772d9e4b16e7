// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patches/recut_points.hpp"
#include "planescope/pipeline.hpp"

namespace planescope {

/// Cuts along surfaces instead of along voxels: a point of a patch that borders on another segment
/// goes to that one of the two patches whose surface it lies nearer to: the plane or face that the
/// patch is on, else its own plane. What lies beside a patch, rather than above it, counts a tenth;
/// near ties stay, and points on a plane within its rms. Points move between adjacent patches only,
/// and no segment loses its last ones: patches, planes, edges and segments stand. \param scene all
/// but the labels of points. \param surface the cloud that patches were made of. \returns what
/// points are labelled by.
PointPatches recut_borders(const Segmentation& scene, const PointCloud& surface);

}  // namespace planescope
