// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>

/// \file Whether two pictures look alike (target planescope::render).
namespace planescope {

/// [pixel] side of the square over which errors are averaged: a quarter of a degree of visual angle
/// at FLIP's 67 pixels per degree.
inline constexpr int kCompareSquare = 16;

/// The default of `planescope compare --tolerance` for pictures. The same rasteriser on a processor
/// without AVX, which rounds some contours its own way, stays below 0.006; one edge of the graph
/// that flipped, or a letter too many, is above 0.05 (tests/test_render_compare.cpp and
/// tests/cli/cases.txt hold both sides).
inline constexpr double kPictureTolerance = 0.03;

/// How different two pictures look. Errors are FLIP's (Andersson et al., HPG 2020): 0 is no
/// difference, 1 that of blue and green.
struct PictureComparison {
  double worst = 0;                  ///< mean error of the worst square: what a tolerance is for,
                                     ///< because a small wrong thing hardly moves the mean
  std::array<int, 2> worst_at = {};  ///< [pixel] its middle, from the left and the top
  double mean = 0;                   ///< mean error of all pixels
  std::size_t changed = 0;           ///< pixels that are not the same bytes
  std::size_t pixels = 0;

  bool identical() const { return changed == 0; }
};

/// Compares two PNGs of one size; transparent ones over white and over black, and the larger error
/// counts.
/// \param difference if not empty, a PNG is written there: `a` in pale grey and, over it, errors
/// from yellow over red to black.
/// \throws Error{Kind::Input} one is no 8-bit RGB PNG, or the difference cannot be written;
/// \throws Error{Kind::Mismatch} they are of different sizes.
PictureComparison compare_pictures(const std::filesystem::path& a, const std::filesystem::path& b,
                                   const std::filesystem::path& difference = {});

}  // namespace planescope
