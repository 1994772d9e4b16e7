// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "planescope/cloud.hpp"

/// \file Depth and colour images as files: PNG and JPEG by libpng and libjpeg. Files are untrusted:
/// sizes are checked before memory is taken.
namespace planescope {

inline constexpr std::uint32_t kMostImageSide = 8192;  ///< [pixel] larger images are refused

/// Depth as a camera stores it, row by row: whole units, of which a scale says how many are a
/// metre.
struct DepthImage {
  std::uint32_t width = 0, height = 0;  ///< [pixel]
  std::vector<std::uint16_t> values;    ///< 0 and 65535: no return

  std::size_t size() const noexcept { return values.size(); }
};

/// A colour image, row by row; without pixels where there is none.
struct ColorImage {
  std::uint32_t width = 0, height = 0;  ///< [pixel]
  std::vector<Rgb> pixels;

  bool empty() const noexcept { return pixels.empty(); }
};

/// Reads a depth image: PNG, grey, 16 bits.
/// \throws Error{Kind::Input} missing, no PNG, another kind of image, truncated or damaged, or
/// larger than kMostImageSide.
DepthImage read_depth_image(const std::filesystem::path& file);

/// Reads a colour image: PNG (any kind; made RGB of 8 bits, transparency ignored) or JPEG, by
/// content.
/// \throws Error{Kind::Input} missing, neither, truncated or damaged, or larger than
/// kMostImageSide.
ColorImage read_color_image(const std::filesystem::path& file);

/// Writes a depth image as PNG, grey, 16 bits, whole or not at all.
/// \throws Error{Kind::Input} it cannot be written; Error{Kind::Usage} its size does not fit its
/// values.
void write_depth_image(const DepthImage& image, const std::filesystem::path& png);

/// Writes a colour image as PNG, RGB, 8 bits, whole or not at all. \throws Error as above.
void write_color_image(const ColorImage& image, const std::filesystem::path& png);

}  // namespace planescope
