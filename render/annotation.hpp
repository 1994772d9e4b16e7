// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include <vtkRenderer.h>

#include "image.hpp"

/// \file Words and swatches in a picture: a band with title and legend above the scene, a note
/// below.
namespace planescope::draw {

/// One entry of a legend.
struct LegendEntry {
  enum class Swatch { ThinLine, DashedLine, Box };
  Swatch swatch = Swatch::Box;
  Pixel color{};
  std::string text;
};

/// What a picture says.
struct Annotation {
  std::string title;                ///< top left
  std::vector<LegendEntry> legend;  ///< top right
  std::string note;                 ///< small and grey, bottom left

  bool has_band() const { return !title.empty() || !legend.empty(); }
};

/// Sizes that scale with the picture.
struct Layout {
  /// For a picture of width x height pixels.
  Layout(int width, int height, const Annotation& annotation);

  int width, height;
  int font;    ///< [pixel] size of the title and legend
  int band;    ///< [pixel] height of the band above the scene; 0 without words
  int footer;  ///< [pixel] height of the note's line below it; 0 without a note
  bool legend_below_title = false;  ///< they do not fit side by side
};

/// Adds the words to a renderer as overlay, on the background's colour: where the scene has strays,
/// they do not run through the words. `scale`: the picture is drawn this much larger than the
/// layout's pixels. RemoveAllViewProps() takes all of it off.
void annotate(vtkRenderer& renderer, const Annotation& annotation, const Layout& layout, int scale,
              const std::array<double, 3>& background);

}  // namespace planescope::draw
