// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include <vtkRenderer.h>

#include "image.hpp"

/// \file Flat things over a picture, in the pixels of the picture that is drawn, from its lower
/// left corner.
namespace planescope::draw {

/// Where a text stands about its place.
enum class Anchor { Left, Centre, Right };

/// A line of text, its middle at height y. `ground`: painted behind it, so that it is read over a
/// scene.
void add_text(vtkRenderer& renderer, const std::string& text, const std::array<double, 2>& place,
              double size, const Pixel& color, Anchor anchor = Anchor::Left,
              const Pixel* ground = nullptr);

/// A filled rectangle from its lower left corner.
void add_box(vtkRenderer& renderer, double x, double y, double width, double height,
             const Pixel& color);

/// A line of some width.
void add_line(vtkRenderer& renderer, const std::array<double, 2>& from,
              const std::array<double, 2>& to, double width, const Pixel& color);

/// A width that a text surely fits into.
double text_width(const std::string& text, double font);

}  // namespace planescope::draw
