// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "image.hpp"

/// \file How different two pictures look to someone who flips between them: FLIP (Andersson,
/// Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild: "FLIP: A Difference Evaluator for
/// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020), written from the
/// paper.
namespace planescope::draw {

/// [pixel] per degree of visual angle: a screen 0.7 m and 3840 pixels wide, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.0206;

/// FLIP's error of each pixel, rows from the top: 0 (no difference) to 1 (blue against green).
/// Both pictures are opaque and of one size.
std::vector<float> flip_errors(const Image& a, const Image& b);

}  // namespace planescope::draw
