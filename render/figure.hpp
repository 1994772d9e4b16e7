// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "annotation.hpp"
#include "drawing.hpp"
#include "image.hpp"
#include "planescope/render.hpp"

/// \file Figures: several panels in one picture, and what each of them says.
namespace planescope::draw {

/// A panel: layers and words.
struct Panel {
  Layer layers;
  Annotation annotation;
};

/// The four panels of overview.png: scene, segments, planes, graph, with their counts.
std::vector<Panel> overview_panels(const SceneData& scene);

/// 1234567 as `1,234,567`.
std::string grouped(std::size_t number);

/// Title and legend of a picture with these layers; the legend says what lines mean and how many
/// there are.
Annotation describe(const SceneData& scene, Layer layers, const std::string& title);

/// Pictures as panels in rows of `columns`, with thin lines between them, the whole of the given
/// size. Pictures that are larger than their panel are shrunk.
Image arrange(const std::vector<Image>& pictures, std::size_t columns,
              const std::array<int, 2>& size, const Pixel& background);

/// Size of a panel in such an arrangement.
std::array<int, 2> panel_size(std::size_t count, std::size_t columns,
                              const std::array<int, 2>& size);

/// True if a picture of this size can be shrunk into a panel of half its side, and is read there as
/// if it had been drawn for it: letters and lines are beyond their least sizes.
bool shrinks_well(const std::array<int, 2>& size);

/// Panels, drawn in rows of `columns`, with thin lines between them; each as large as the others,
/// the whole of the given size.
Image draw_panels(Drawing& drawing, const std::vector<Panel>& panels, std::size_t columns,
                  const std::array<int, 2>& size, const Pixel& background);

}  // namespace planescope::draw
