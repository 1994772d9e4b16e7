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

/// Title and legend of a picture with these layers; the legend says what lines mean and how many
/// there are.
Annotation describe(const SceneData& scene, Layer layers, const std::string& title);

/// Panels in rows of `columns`, with thin lines between them; each as large as the others, the
/// whole of the given size.
Image draw_panels(Drawing& drawing, const std::vector<Panel>& panels, std::size_t columns,
                  const std::array<int, 2>& size, const Pixel& background);

}  // namespace planescope::draw
