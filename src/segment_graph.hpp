// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "patches/recut_points.hpp"
#include "planes/held_planes.hpp"
#include "planes/shared_directions.hpp"
#include "planescope/options.hpp"
#include "planescope/pipeline.hpp"

namespace planescope {

/// What segment() makes of patches: scene.graph is there; all but the labels of points is made
/// anew, and scene.times. \param held what an earlier run over most of these patches found: the
/// search goes on from it, and its planes become those of this run. Null: from nothing.
void segment_graph(Segmentation& scene, const Options& options, const Progress& progress = {},
                   HeldPlanes* held = nullptr);

// Stages of segment_graph().

/// Finds the faces: they come behind the supporting planes, which alone cut (eq. (1)).
/// \param held as above.
void add_faces(Segmentation& scene, const PlaneOptions& options, HeldPlanes* held = nullptr);

/// Planes of one direction share it; then margins are measured, and patches on faces get their
/// normals.
void settle_planes(Segmentation& scene, const PlaneOptions& options,
                   const DirectionTolerance& tolerance);

/// What holds for a patch holds for its points: fills point_label and point_plane, and the counts
/// of points of segments and planes. \param points the patches that they are labelled by.
void label_points(Segmentation& scene, const PointPatches& points);

}  // namespace planescope
