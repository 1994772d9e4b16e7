// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "baselines/baselines.hpp"
#include "baselines/peer_options.hpp"
#include "planescope/pipeline.hpp"

/// \file A peer's answer in the form of ours, so that all that stores, draws and scores takes both.
namespace planescope {

/// Runs a peer: `ransac`, `lccp` or `cpc`. What it lacks stays empty, and method says so.
/// \param options of ours: their scale is stored with the result where the peer has none.
/// \throws Error{Kind::Usage} another name; else as ransac(), lccp(), cpc().
Segmentation peer_segmentation(std::string_view method, const PointCloud& cloud,
                               const Options& options, const PeerOptions& peers);

/// What peer_segmentation() does with an answer. Segments' and planes' areas of a method without
/// patches are those of the voxels (edge `options.patches.voxel_size`) that their points occupy.
/// Edges are ON where the peer joins the two patches directly. It does not say why: the rule is the
/// one that classify_edges() gives with the peer's tolerances or, where that contradicts the peer,
/// the nearest one that does not, with margin 0.
Segmentation to_segmentation(PeerResult&& peer, const PointCloud& cloud, const Options& options,
                             const EdgeOptions& edges);

}  // namespace planescope
