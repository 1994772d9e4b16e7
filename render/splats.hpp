// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scene_data.hpp"

/// \file How large points are drawn.
namespace planescope::draw {

/// Squares are drawn faster; where splats are large, corners show.
enum class SplatShape { Square, Disc };

/// From metres to pixels of the picture that is drawn, before it is shrunk.
struct PointScale {
  double pixels_per_metre_at_1m = 0;  ///< parallel: anywhere
  double fixed = 0;                   ///< [pixel] 0: by spacing
  double least = 1, most = 64;        ///< [pixel]
  SplatShape shape = SplatShape::Square;

  /// [pixel] of a splat of this diameter [m] at this depth [m] (parallel: 1).
  float pixels(float diameter, float depth) const {
    if (fixed > 0) return static_cast<float>(fixed);
    return std::clamp(diameter * static_cast<float>(pixels_per_metre_at_1m) / depth,
                      static_cast<float>(least), static_cast<float>(most));
  }
};

/// Diameters of splats [m], and what is usual among them.
struct Splats {
  std::vector<float> diameters;  ///< of each point that is drawn
  double usual = 0;
};

/// 1.7 times the local spacing of the points, sqrt(area / points) of their patch: surfaces close
/// near and far, whatever the sensor's density there. Patches of a few points are no surface, and
/// their points small. \param points indices of those that are drawn.
Splats splats(const SceneData& scene, const std::vector<std::uint32_t>& points);

/// The scale with discs in place of squares of the same area, if splats that usually have this
/// diameter [m] are at this depth [m] (parallel: 1) at least `round_from` pixels large.
PointScale rounded(PointScale scale, double usual, double depth, double round_from);

}  // namespace planescope::draw
