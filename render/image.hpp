// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "png_chunks.hpp"

/// \file Pictures as plain pixels: what is done to them between VTK's window and the PNG.
namespace planescope::draw {

using Pixel = std::array<std::uint8_t, 3>;  ///< R, G, B; sRGB

/// An 8-bit RGB picture, rows from the top.
struct Image {
  int width = 0, height = 0;          ///< [pixel]
  std::vector<std::uint8_t> rgb;      ///< 3 * width * height bytes, top row first
  std::vector<std::uint8_t> alpha{};  ///< one byte a pixel, 255 is opaque; or empty: all opaque

  bool operator==(const Image&) const = default;
};

/// A picture of one colour.
Image filled(int width, int height, const Pixel& color);

/// The mean over blocks of factor x factor (1 to 4) pixels, rounded; width and height must be
/// multiples of `factor`. In sRGB, not in light: thin dark lines on white keep their weight.
Image downsample(const Image& image, int factor);

/// A picture that lies elsewhere, three bytes a pixel.
struct PixelRows {
  const std::uint8_t* top;  ///< the uppermost row
  std::ptrdiff_t step;      ///< [byte] to the next one below it
  int width, height;
};

/// The same of such a picture; with a factor of 1, a copy.
Image downsample(const PixelRows& rows, int factor);

/// The picture at another, smaller size: each pixel is the mean of the area that it covers, in sRGB
/// as above. `width` and `height` must not exceed the picture's.
Image shrunk(const Image& image, int width, int height);

/// The picture whose opaque parts, over white and over black, look like these two of one size: what
/// lets white through and black not is transparent (difference matting).
Image matte(const Image& on_white, const Image& on_black);

/// True if all pixels of the rows [first, last) are alike: nothing was drawn there.
bool is_uniform(const Image& image, int first, int last);

/// Copies `piece` into `canvas` with its top left corner at (x, y); it must lie inside.
void paste(Image& canvas, const Image& piece, int x, int y);

/// The picture as the bytes of a PNG file; same picture and notes, same bytes.
/// \throws Error{Kind::Rendering} the encoder refuses.
std::string encode_png(const Image& image, const PngNotes& notes = {});

/// Writes the PNG whole or not at all. \throws Error{Kind::Input} it cannot be written.
void write_png(const Image& image, const std::filesystem::path& file, const PngNotes& notes = {});

/// Reads an 8-bit RGB or RGBA PNG.
/// \throws Error{Kind::Input} it is missing, or no such PNG.
Image read_png(const std::filesystem::path& file);

}  // namespace planescope::draw
