// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "camera.hpp"
#include "close_up.hpp"

namespace planescope::draw {

/// Translucent fills in painter's order, and outlines `width` pixels of the drawn picture wide, all
/// moved towards the camera by `lift` [m], out of the points' noise.
Actors sheet_actors(const std::vector<Sheet>& sheets, const Camera& camera, double width,
                    double lift);

}  // namespace planescope::draw
