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
/// anew, and scene.times. The stages below, one after the other.
void segment_graph(Segmentation& scene, const Options& options, const Progress& progress = {});

/// Hypotheses and selection (IV-A, IV-B). \param held what an earlier run over most of these
/// patches found: the search goes on from it, and its planes become those of this run. Null: from
/// nothing.
void find_planes(Segmentation& scene, const Options& options, const Progress& progress = {},
                 HeldPlanes* held = nullptr);

/// Which patches are on them (IV-C), and the planes refitted to these.
void assign_patches(Segmentation& scene, const Options& options, const Progress& progress = {});

/// The hypotheses of faces among the other patches, the faces selected. \param held as above.
std::vector<HeldPlane> select_faces(Segmentation& scene, const PlaneOptions& options,
                                    const HeldPlanes* held = nullptr);

/// These faces, and all planes in their final place: add_faces(), settle_planes().
void complete_planes(Segmentation& scene, const Options& options,
                     const std::vector<HeldPlane>& faces);

/// Edges (III-B, eq. (1)) and segments.
void connect_patches(Segmentation& scene, const Options& options);

// Parts of complete_planes().

/// The selected ones come behind the supporting planes, which alone cut (eq. (1)).
void add_faces(Segmentation& scene, const PlaneOptions& options,
               const std::vector<HeldPlane>& faces);

/// Planes of one direction share it; then margins are measured, and patches on faces get their
/// normals.
void settle_planes(Segmentation& scene, const PlaneOptions& options,
                   const DirectionTolerance& tolerance);

/// What holds for a patch holds for its points: fills point_label and point_plane, and the counts
/// of points of segments and planes. \param points the patches that they are labelled by.
void label_points(Segmentation& scene, const PointPatches& points);

}  // namespace planescope
