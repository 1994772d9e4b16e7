// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "image.hpp"
#include "planescope/close_up.hpp"
#include "shape_layers.hpp"
#include "solids.hpp"

/// \file What close-ups have in common: a ball of the scene, some patches of it in colour, things
/// drawn over them, and a panel of words.
namespace planescope::draw {

/// A line of the panel. A row is up to three cells with tabs between them.
struct PanelLine {
  enum class Style { Title, Strong, Plain, Small, Swatch, Row, Space };
  std::string text;
  Style style = Style::Plain;
  Pixel color = {35, 38, 43};  ///< of the words, or of the swatch before them
};

/// A translucent, outlined polygon in a plane.
struct Sheet {
  std::vector<Eigen::Vector3d> corners;
  Eigen::Vector3d normal;
  Pixel color{};
};

/// A number in the picture.
struct Tag {
  Eigen::Vector3d place;
  std::string text;
};

/// What is drawn.
struct CloseUp {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();    ///< [m] of what is shown
  double radius = 1;                                   ///< [m]
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  ///< unit: about where the camera stands
  std::map<std::uint32_t, Pixel> patches;              ///< in colour; all others are faded
  std::vector<std::uint32_t> watched;                  ///< patches that must be seen; none: those
  Solids solids;
  std::vector<Sheet> sheets;
  std::vector<Tag> tags;
  std::vector<PanelLine> panel;
};

/// Draws it and writes the PNG. The camera is the one of some directions about `towards` from which
/// least stands before the patches.
void draw(const StoredScene& stored, const CloseUp& what, const CloseUpOptions& options,
          const std::filesystem::path& png);

/// The outline of patches in a plane: the hull of their centroids, grown by half a patch.
Sheet outline(const StoredScene& stored, const Plane& plane,
              const std::vector<std::uint32_t>& patches, const Pixel& color);

/// The words of a panel, top down, on white; lines that are too long are broken. `measure`: the
/// panel's width over the size of its letters.
Image draw_panel(const std::vector<PanelLine>& lines, int width, int height, int scale,
                 double measure = 26);

inline constexpr Pixel kFirstPatch = {217, 119, 6};    ///< amber
inline constexpr Pixel kSecondPatch = {21, 128, 161};  ///< teal
inline constexpr Pixel kWrong = {190, 18, 60};         ///< crimson

}  // namespace planescope::draw
