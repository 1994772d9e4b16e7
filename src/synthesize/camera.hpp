// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "synthesize/raycaster.hpp"
#include "synthesize/room.hpp"

namespace planescope::synthesis {

inline constexpr double kNearest = 0.5, kFarthest = 6.0;  ///< [m] range of the depth cameras

/// A pinhole depth camera: x right, y down, z forward; a point (x, y, z) of its frame is seen at
/// column f x / z + cx, row f y / z + cy.
struct Camera {
  int width = 640, height = 480;               ///< [pixel]
  double focal = 525, cx = 319.5, cy = 239.5;  ///< [pixel]
  Isometry3d pose = Isometry3d::Identity();    ///< camera to world

  /// Through a pixel's centre; its parameter t is the depth z [m].
  Ray ray(double column, double row) const;
};

/// What a camera sees without noise, a pixel each, row by row.
struct DepthView {
  std::vector<float> depth;           ///< [m] along the camera's z; 0: nothing there
  std::vector<std::int32_t> surface;  ///< index into Scene::surfaces(), or kNone
};

/// Renders the depth image of a scene, rows in parallel.
DepthView render_depth(const RayCaster& caster, const Camera& camera);

/// Camera to world, for a camera at `eye` that looks along `yaw` [rad, from x to y], `pitch` below
/// the horizon, and is rolled clockwise.
Isometry3d aim(const Vector3d& eye, double yaw, double pitch, double roll);

/// Seeded poses inside the room, 1.2 to 1.8 m above the floor, in free space, each looking at
/// another piece of furniture, 10 to 35 degrees downwards and rolled by a few degrees. Of a dozen
/// poses a view, that which sees most pieces from within 0.5 to 6 m is taken.
std::vector<Camera> place_cameras(const Room& room, const RayCaster& caster, std::uint64_t seed,
                                  std::uint32_t count);

}  // namespace planescope::synthesis
