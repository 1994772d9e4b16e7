// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "annotation.hpp"
#include "camera.hpp"
#include "planescope/render.hpp"
#include "point_colors.hpp"
#include "scene_data.hpp"
#include "viewpoint.hpp"

/// \file What a picture says of its scene: legends, numbers, lengths and directions.
namespace planescope::draw {

/// What the colours of the points or, over grey ones, of the planes say; empty where they speak for
/// themselves (the cloud's own).
std::vector<LegendEntry> color_legend(const SceneData& scene, const SceneColors& colors,
                                      const PointColors& way, Layer layers);

/// The numbers of segments, largest first: at their centroids or, where something else is seen
/// there, as near to them as they lie on what they name. Segments of which less is seen than their
/// number would cover, and those that are cut away, have none.
std::vector<Mark> segment_marks(const SceneData& scene, const Cutaway& cut, const Camera& camera,
                                const Layout& layout);

/// A bar of 1, 2 or 5 times a power of ten, at most a fifth of the picture wide. In perspective it
/// holds at the distance of the scene's middle, and says so.
ScaleBar scale_bar(const Camera& camera, const Layout& layout);

/// x, y and z of the scene's coordinates as the camera sees them, the nearest last.
std::vector<AxisMark> axis_marks(const Camera& camera);

/// `1.5 m`, `20 cm`, `5 mm`.
std::string length_text(double metres);

}  // namespace planescope::draw
