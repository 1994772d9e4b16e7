// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>

#include "planescope/explain.hpp"
#include "planescope/explain_planes.hpp"
#include "planescope/stored_scene.hpp"

/// \file Pictures of what an explanation is about (target planescope::render): the place from near
/// by, its neighbourhood faded, and the numbers beside it.
namespace planescope {

/// How a close-up is drawn.
struct CloseUpOptions {
  std::array<int, 2> size = {1600, 1000};  ///< [pixel] with the panel of words; at least 320 x 200
  int supersample = 2;                     ///< 1 to 4
};

/// An edge: both patches in colour, their normals as arrows, the line between their centroids, the
/// planes that they lie on; measures beside thresholds, and what would flip it.
/// \throws as render().
void draw_close_up(const StoredScene& stored, const EdgeExplanation& explanation,
                   const CloseUpOptions& options, const std::filesystem::path& png);

/// A chain: its patches and edges as tubes, the weakest of those that decide standing out.
void draw_close_up(const StoredScene& stored, const Chain& chain, const CloseUpOptions& options,
                   const std::filesystem::path& png);

/// A plane: its patches, and the outlines of the hypotheses that it beat.
void draw_close_up(const StoredScene& stored, const PlaneExplanation& explanation,
                   const CloseUpOptions& options, const std::filesystem::path& png);

/// A place without a plane: the nearest patch, the plane that would grow from it, and the
/// hypotheses near it.
void draw_close_up(const StoredScene& stored, const MissingExplanation& explanation,
                   const CloseUpOptions& options, const std::filesystem::path& png);

}  // namespace planescope
