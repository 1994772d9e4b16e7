// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// \file The chunks of a PNG file (ISO/IEC 15948): what it says of itself beside its pixels.
namespace planescope::draw {

/// A chunk: four letters, and its data.
struct PngChunk {
  std::string type, data;
};

/// What is said in a PNG.
struct PngNotes {
  std::vector<std::pair<std::string, std::string>> texts;  ///< keyword (Latin-1) and UTF-8 text
  double dpi = 0;                                          ///< 0: not said
};

/// The chunks of a PNG, in order. \throws Error{Kind::Input} it is none, or a checksum is wrong.
/// \param name of where the bytes are from, for messages.
std::vector<PngChunk> png_chunks(std::string_view png, const std::string& name);

/// The bytes of a PNG of these chunks.
std::string join_chunks(const std::vector<PngChunk>& chunks);

/// The PNG with notes: pHYs, and one iTXt for each text, before the pixels.
std::string with_notes(std::string_view png, const PngNotes& notes);

/// The iTXt and tEXt texts of a PNG. \throws as png_chunks().
std::vector<std::pair<std::string, std::string>> png_texts(std::string_view png,
                                                           const std::string& name);

/// 32-bit number in network order, as PNG has it.
std::string big_endian(std::uint32_t value);

}  // namespace planescope::draw
