// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <vtkRenderer.h>

#include "image.hpp"

/// \file Words and swatches in a picture: a band with title and legend above the scene, a note and
/// a scale bar below, marks on it.
namespace planescope::draw {

/// One entry of a legend.
struct LegendEntry {
  enum class Swatch { ThinLine, DashedLine, Box, None };
  Swatch swatch = Swatch::Box;
  Pixel color{};
  std::string text;
};

/// A text at a place in the picture.
struct Mark {
  std::string text;
  std::array<double, 2> place;  ///< normalised: -1 to 1, x to the right, y upwards
};

/// A bar that says how long things are.
struct ScaleBar {
  double share = 0;  ///< of the picture's width
  std::string text;
};

/// A direction as it is seen, and its name.
struct AxisMark {
  std::array<double, 2> tip;  ///< from their common origin, 1 is the full length
  Pixel color{};
  std::string name;
};

/// What a picture says.
struct Annotation {
  std::string title;                    ///< top left
  std::vector<LegendEntry> legend;      ///< top right
  std::string note;                     ///< small and grey, bottom left
  std::optional<ScaleBar> scale_bar{};  ///< bottom right
  std::vector<AxisMark> axes{};         ///< bottom left, above the note
  std::vector<Mark> marks{};            ///< over the scene

  bool has_band() const { return !title.empty() || !legend.empty(); }
};

/// Sizes that scale with the picture.
struct Layout {
  /// For a picture of width x height pixels.
  Layout(int width, int height, const Annotation& annotation);

  int width, height;
  int font;    ///< [pixel] size of the title and legend
  int band;    ///< [pixel] height of the band above the scene; 0 without words
  int footer;  ///< [pixel] height of the line below it; 0 without a note or a bar
  bool legend_below_title = false;  ///< they do not fit side by side
};

/// Drops entries from the end of the legend until it fits beside or below the title, and says how
/// many.
void shorten_legend(Annotation& annotation, int width, int height);

/// Of marks that would lie over each other or over the picture's rim, the first stays.
/// \returns how many were taken away.
std::size_t thin_out(std::vector<Mark>& marks, const Layout& layout);

/// Adds the words to a renderer as overlay, on the background's colour: where the scene has strays,
/// they do not run through the words. `scale`: the picture is drawn this much larger than the
/// layout's pixels. `background`: painted under the words; `words_on`: what they are to be read on.
/// RemoveAllViewProps() takes all of it off.
void annotate(vtkRenderer& renderer, const Annotation& annotation, const Layout& layout, int scale,
              const std::array<double, 3>& background, const std::array<double, 3>& words_on);

}  // namespace planescope::draw
