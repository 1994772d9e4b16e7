// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planescope/patches.hpp"
#include "planescope/pipeline.hpp"

/// \file What eq. (6) rewards is also true: planes that are nearly parallel or orthogonal are
/// exactly so, as far as their own accuracy lets one tell.
namespace planescope {

/// How far a plane may be turned towards the directions of the others.
struct DirectionTolerance {
  double angle = 5;          ///< [deg] at most
  double face_sigma = 0;     ///< [m] inlier distance of faces
  double support_sigma = 0;  ///< [m] of supporting planes
  double surface_error = 0;  ///< [m] rms distance of patches from the surface that they stand for,
                             ///< beyond what residuals show; see surface_error()
};

/// What smoothing (PatchOptions::smoothing) does to surfaces and residuals do not show, because
/// neighbours err alike: two levels less than a cell apart become one ramp. The line nearest to a
/// step of one cell has an rms of sqrt(3) / 4 cells, and that is the error. Against the truth of
/// synthesized rooms seen by 8 cameras, patches of furniture lie off their faces by a third of a
/// cell (rms). \returns [m]
double surface_error(double smoothing);

/// What the options say: eq. (6)'s alpha is the largest turn; where angles weigh nothing, none.
DirectionTolerance direction_tolerance(const Options& options);

/// Ties planes that are parallel or orthogonal, within their accuracy, to shared frames of three
/// orthogonal directions, and fits each frame to all patches of its planes at once: least squares
/// over rotations, each plane weighing its area over its own variance. Offsets stay free. The
/// largest planes found the frames; a plane that is orthogonal to one direction of a frame and to
/// no other (a box turned on its table) founds a frame that shares this direction.
///
/// A plane is tied where the turn is at most `tolerance.angle` and lifts the rms distance of its
/// patches no further than that of the same plane fitted twice might differ (1.5 times, or a
/// quarter of its inlier distance), plus the surface's error in quadrature; else it stays as it is,
/// so that what is slanted stays slanted. A turn of t degrees lifts the rms of a plane as wide as w
/// by t w / 200: small planes turn further than walls.
///
/// Differs from the paper, which rewards near-orthogonality in the selection and keeps the planes
/// as they were fitted. \param planes supporting planes and faces; normals, distances and rms
/// change. \param patch_plane per patch: index into `planes`, or kNone.
void share_directions(std::vector<SupportingPlane>& planes, std::span<const Patch> patches,
                      std::span<const std::int32_t> patch_plane,
                      const DirectionTolerance& tolerance);

}  // namespace planescope
