// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
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

/// How a figure is laid out.
struct FigureOptions {
  /// View, up, background and points. Its `size`, `layers` and `title` are ignored.
  RenderOptions drawing;
  double width_mm = 85;  ///< [mm] in print, 10 to 1000: 85 is a column, 180 a page of most
                         ///< journals; panels are 4:3
  /// [pixel] The whole figure; instead of `width_mm` and 4:3.
  std::optional<std::array<int, 2>> size;
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
