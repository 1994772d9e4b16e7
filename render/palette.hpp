// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "image.hpp"

/// \file Colours: which ones there are, and how different two of them look.
namespace planescope::draw {

/// How a reader sees: with three kinds of cones, or without one of them.
/// Grey: in print without colours.
enum class Vision { Normal, Protanopia, Deuteranopia, Tritanopia, Grey };
inline constexpr std::array kVisions = {Vision::Normal, Vision::Protanopia, Vision::Deuteranopia,
                                        Vision::Tritanopia, Vision::Grey};

/// What a colour looks like to such a reader. Protanopia, deuteranopia and tritanopia by the
/// matrices of Machado, Oliveira and Fernandes (IEEE TVCG 15(6), 2009) at full severity, in linear
/// light. Grey: the grey of the same luminance.
Pixel seen_by(Vision vision, const Pixel& color);

/// Oklab coordinates (Ottosson 2020): lightness from 0 to 1, and two opponent axes; Euclidean
/// distance is about as large as the difference that is seen.
Eigen::Vector3d to_oklab(const Pixel& color);

/// The colour nearest to these Oklab lightness, chroma and hue [deg] that sRGB can show: chroma is
/// lowered until it fits.
Pixel from_oklch(double lightness, double chroma, double hue);

/// How different two colours look to such a reader: their Oklab distance.
double difference(const Pixel& a, const Pixel& b, Vision vision);

/// How different two colours look to the reader who tells them apart worst: the least Oklab
/// distance over all kinds of vision.
double contrast(const Pixel& a, const Pixel& b);

/// Candidates for large planes: light and muted, so that they step back.
std::vector<Pixel> calm_colors();
/// Candidates for objects: saturated, in three clearly different lightnesses.
std::vector<Pixel> vivid_colors();

/// Steps of grey.
std::vector<Pixel> grey_colors();

/// A colour of the same hue, deep enough to be seen through: that of a plane, from the colour of
/// the segment on it.
Pixel deepened(const Pixel& color);

/// A direction as a colour: |x|, |y|, |z| of a unit normal as red, green, blue, paled; opposite
/// sides are alike.
Pixel direction_color(const Eigen::Vector3d& normal);

/// Viridis-like map of a quantity, t from 0 (dark blue) to 1 (yellow): lightness grows evenly.
Pixel ramp_color(double t);

/// A calm map of height, t from 0 (lowest) to 1: dusk blue over sage to sand.
Pixel height_color(double t);

/// `color` moved towards white; 0 leaves it, 1 is white.
Pixel lighten(const Pixel& color, double amount);
/// `color` moved towards black.
Pixel darken(const Pixel& color, double amount);

/// Rec. 709 luma of a colour, 0 to 255: what is left of it in grey.
double luma(const Pixel& color);

inline constexpr Pixel kUnlabelled = {150, 150, 150};  ///< points in no segment
inline constexpr Pixel kInk = {35, 38, 43};            ///< text
inline constexpr Pixel kEdgeOn = {74, 128, 208};       ///< ON edges: light, thin, solid
inline constexpr Pixel kEdgeOff = {176, 22, 14};       ///< OFF edges: dark, thick, dashed

}  // namespace planescope::draw
