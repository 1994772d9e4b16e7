// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// \file PNG by libpng, in memory. Its errors are long jumps: they end here.
namespace planescope::io {

/// Rows of samples, without gaps: grey of 16 bits (in the machine's order), or RGB of 8 bits.
struct PngPixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::byte> samples;
};

enum class PngKind {
  Depth,  ///< grey, 16 bits; nothing else is taken
  Color,  ///< RGB, 8 bits; other kinds are converted
  // For writing:
  Drawing,           ///< RGB, 8 bits, with flat areas
  DrawingWithAlpha,  ///< the same in RGBA
};

bool is_png(std::span<const std::byte> bytes);

/// \param name of where the bytes are from, for messages.
/// \throws Error{Kind::Input} truncated, damaged, too large, or another kind of image.
PngPixels decode_png(const std::string& name, std::span<const std::byte> bytes, PngKind kind);

/// The file's bytes. \throws Error{Kind::Internal} libpng refuses.
std::string encode_png(PngPixels pixels, PngKind kind);

}  // namespace planescope::io
