// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "png_chunks.hpp"

#include <array>
#include <cmath>

#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

/// CRC-32 of ISO 3309, by table.
std::uint32_t checksum(std::string_view bytes) {
  static const auto kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t c = i;
      for (int bit = 0; bit < 8; ++bit) c = (c & 1U) != 0 ? 0xedb88320U ^ (c >> 1U) : c >> 1U;
      table[i] = c;
    }
    return table;
  }();
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes)
    crc = kTable[(crc ^ static_cast<unsigned char>(c)) & 255U] ^ (crc >> 8U);
  return crc ^ 0xffffffffU;
}

std::uint32_t read_number(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Keyword, no compression, no language, no translation, text.
PngChunk text_chunk(const std::string& keyword, const std::string& text) {
  return {"iTXt", keyword + std::string(5, '\0') + text};
}

PngChunk resolution_chunk(double dpi) {
  const std::string per_metre = big_endian(static_cast<std::uint32_t>(std::lround(dpi / 0.0254)));
  return {"pHYs", per_metre + per_metre + '\1'};
}

}  // namespace

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(value >> static_cast<unsigned>(shift) & 255U);
  return bytes;
}

std::vector<PngChunk> png_chunks(std::string_view png, const std::string& name) {
  const auto refuse = [&](const std::string& what) {
    throw Error(Error::Kind::Input, name + ": " + what + "; is it a whole PNG file?");
  };
  if (!png.starts_with(kSignature)) refuse("does not start as a PNG");
  std::vector<PngChunk> chunks;
  std::size_t at = kSignature.size();
  while (at < png.size()) {
    if (png.size() - at < 12) refuse("ends within a chunk");
    const std::uint32_t length = read_number(png, at);
    if (length > png.size() - at - 12) refuse("ends within a chunk");
    const std::string_view body = png.substr(at + 4, 4 + std::size_t{length});
    at += 8 + std::size_t{length};
    if (read_number(png, at) != checksum(body))
      refuse("has a wrong checksum at byte " + std::to_string(at));
    at += 4;
    chunks.push_back({std::string(body.substr(0, 4)), std::string(body.substr(4))});
  }
  return chunks;
}

std::string join_chunks(const std::vector<PngChunk>& chunks) {
  std::string png(kSignature);
  for (const PngChunk& chunk : chunks) {
    const std::string body = chunk.type + chunk.data;
    png += big_endian(static_cast<std::uint32_t>(chunk.data.size())) + body;
    png += big_endian(checksum(body));
  }
  return png;
}

std::string with_notes(std::string_view png, const PngNotes& notes) {
  std::vector<PngChunk> chunks = png_chunks(png, "the encoder's output");
  std::vector<PngChunk> added;
  if (notes.dpi > 0) added.push_back(resolution_chunk(notes.dpi));
  for (const auto& [keyword, text] : notes.texts) added.push_back(text_chunk(keyword, text));
  chunks.insert(chunks.begin() + 1, added.begin(), added.end());  // after IHDR
  return join_chunks(chunks);
}

std::vector<std::pair<std::string, std::string>> png_texts(std::string_view png,
                                                           const std::string& name) {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const PngChunk& chunk : png_chunks(png, name)) {
    const std::size_t end = chunk.data.find('\0');
    if (end == std::string::npos) continue;
    const std::string keyword = chunk.data.substr(0, end);
    if (chunk.type == "tEXt") texts.emplace_back(keyword, chunk.data.substr(end + 1));
    const std::string plain(5, '\0');  // as text_chunk() writes it
    if (chunk.type == "iTXt" && chunk.data.compare(end, 5, plain) == 0)
      texts.emplace_back(keyword, chunk.data.substr(end + 5));
  }
  return texts;
}

}  // namespace planescope::draw
