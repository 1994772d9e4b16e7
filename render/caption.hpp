// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "image.hpp"

/// \file Words as pixels, set at a size in print: for captions, which stand outside of the scene.
namespace planescope::draw {

/// A line of text, as large as its words. \param points size of the font in print, at `dpi`.
/// \throws Error{Kind::Rendering} the font engine refuses.
Image draw_text(const std::string& text, double points, double dpi, const Pixel& ink,
                const Pixel& ground);
}  // namespace planescope::draw
