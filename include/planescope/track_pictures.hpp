// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "planescope/render.hpp"
#include "planescope/track.hpp"

/// \file How a map grew, as an animation and as a plot (target planescope::render).
namespace planescope {

/// The camera that render() would take for a scene; nothing is written.
/// \throws Error as render().
Camera fit_camera(const Segmentation& scene, const PointCloud& cloud, const RenderOptions& options);

/// The map of a tracker as it is, each object in the colour that its number has for ever, as an
/// encoded PNG. \param options camera and size; layers and colours are not used. \param title of
/// the picture. \returns nothing where the tracker has no point yet.
/// \throws Error as render(), but a picture may be uniform: a camera may not see the map yet.
std::string picture_of(const MapTracker& tracker, const RenderOptions& options,
                       const std::string& title);

/// Encoded pictures of one size as an animated PNG that plays for ever, each for `milliseconds`.
/// \throws Error{Kind::Usage} no picture; Error{Kind::Input} it cannot be written.
void write_animation(const std::vector<std::string>& pngs, int milliseconds,
                     const std::filesystem::path& png);

/// What a plot shows of one frame.
struct TrackPlotRow {
  std::uint32_t frame = 0;
  double tracking = 0, fusion = 0;   ///< [ms]
  double segments = 0, planes = 0;   ///< of the map so far
  double kept = 1, steady_kept = 1;  ///< [1] share of places, and of those seen often, that kept
                                     ///< their object at the last segmentation
};

/// Three charts over the frames: times, numbers of segments and planes, stability of labels.
/// \throws Error{Kind::Usage} no row; otherwise as render().
void plot_track(const std::vector<TrackPlotRow>& rows, const std::string& title,
                const std::filesystem::path& png);

}  // namespace planescope
