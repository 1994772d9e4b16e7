// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "planescope/sequence.hpp"

namespace planescope::odometry {

/// How well a frame shows where the camera is, in the direction in which it shows it least: along a
/// bare wall a camera moves, and sees the same.
struct Observability {
  /// Least eigenvalue of the mean of n n^T over the surface's normals n: 0 of planes that share a
  /// direction, 1/3 of normals all around.
  double relief = 0;
  /// Least eigenvalue of the mean of j j^T, where j is how a pixel's brightness ([0, 1], its
  /// gradient cut at 0.05 a pixel, so that no few edges decide) changes by a metre of the camera's
  /// motion.
  double texture = 0;
};

/// Brightness of a colour, [0, 1], as Open3D weights them.
inline double brightness(const Rgb& c) {
  return (0.2990 * c.r + 0.5870 * c.g + 0.1140 * c.b) / 255;
}

/// Of about 4800 pixels, evenly spread; normals from neighbours a fortieth of the width apart.
Observability observe(const Frame& frame, const DepthCamera& camera);

}  // namespace planescope::odometry
