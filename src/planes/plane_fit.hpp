// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planes/bits.hpp"
#include "planes/patch_index.hpp"
#include "planescope/planes.hpp"

/// \file Least-squares planes through patches.
namespace planescope {

/// One step of reweighted least squares: the plane that minimises the weighted squared distances of
/// the members' centroids (PCA). A member weighs its area times Tukey's biweight (1 - (r /
/// sigma)^2)^2 of its distance r to `previous`: without it, what stands against a wall and is an
/// inlier of it by its flank would tilt the wall by a degree, and eq. (6) charges for degrees.
/// Where the centroids do not fix a plane (fewer than three, or a strip whose standard deviation
/// across is under `sigma`, so that noise alone could tilt it), the normal is the mean of the
/// members' normals instead. The normal stays on the side of the previous one.
/// \param previous the plane so far; comes back if no member is nearer than sigma to it.
/// \param sigma [m] inlier distance.
Plane fit_plane(const PatchIndex& index, const Bits& members, const Plane& previous, double sigma);

/// `plane` turned so that its normal agrees with most of the members' normals.
Plane orient_plane(const PatchIndex& index, const Bits& members, const Plane& plane);

}  // namespace planescope
