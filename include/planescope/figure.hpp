// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "planescope/render.hpp"

/// \file The figure of a paper: several segmentations of one scene, side by side (target
/// planescope::render).
namespace planescope {

/// A panel: the scene in one colouring.
struct FigurePanel {
  std::string title;                  ///< its caption, after the letter: `LCCP`
  std::string scores;                 ///< a second line; empty: none
  std::vector<std::uint32_t> labels;  ///< per point, 0: in no segment; empty: own colours
  bool is_truth = false;              ///< others take its colours
};

/// RenderOptions of a figure whose size follows from its resolution.
inline RenderOptions whole_column() {
  RenderOptions options;
  options.size = {0, 0};
  return options;
}

/// How a figure is laid out.
struct FigureOptions {
  /// View, up, background and points; `size` is the whole figure's in pixels, or {0, 0}: as wide as
  /// a column (85 mm) at `dpi`, panels 4:3. `layers` and `title` are ignored.
  RenderOptions drawing = whole_column();
  std::uint32_t columns = 2;  ///< panels in a row
  double dpi = 300;           ///< [pixel/inch] 72 to 1200; captions are 7.5 points at it, and the
                              ///< PNG says it
};

/// Draws the panels of a scene with one camera. The same object has the same colour in all of them:
/// segments are matched by overlap, with the truth first, else with the panels before.
/// \param scene gives camera, up direction and the size of points.
/// \throws Error{Kind::Usage} sizes out of range, no panel, or too small for its captions; labels
/// of another number of points. \throws otherwise as render().
void render_figure(const Segmentation& scene, const PointCloud& cloud,
                   const std::vector<FigurePanel>& panels, const FigureOptions& options,
                   const std::filesystem::path& png);

}  // namespace planescope
