// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planes/held_planes.hpp"
#include "planescope/options.hpp"
#include "planescope/pipeline.hpp"

namespace planescope {

/// What segment() makes of patches: scene.graph is there; all but the labels of points is made
/// anew, and scene.times. \param held what an earlier run over most of these patches found: the
/// search goes on from it, and its planes become those of this run. Null: from nothing.
void segment_graph(Segmentation& scene, const Options& options, const Progress& progress = {},
                   HeldPlanes* held = nullptr);

/// What holds for a patch holds for its points: fills point_label and point_plane, and the counts
/// of points of segments and planes. \param point_patch per point: the patch that it is labelled
/// by, or kNone.
void label_points(Segmentation& scene, const std::vector<std::int32_t>& point_patch);

}  // namespace planescope
