// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "animation.hpp"

#include <cstdint>

#include "png_chunks.hpp"

namespace planescope::draw {
namespace {

std::string short_number(int value) {
  return big_endian(static_cast<std::uint32_t>(value)).substr(2);
}

/// fcTL: sequence number, size, offset, delay as a fraction of a second, how it replaces the last.
PngChunk frame_control(std::uint32_t sequence, const std::string& size, int milliseconds) {
  return {"fcTL", big_endian(sequence) + size + std::string(8, '\0') + short_number(milliseconds) +
                      short_number(1000) + std::string(2, '\0')};
}

}  // namespace

std::string animate(const std::vector<std::string>& pngs, int milliseconds) {
  std::vector<PngChunk> all;
  std::uint32_t sequence = 0;
  std::string size;
  for (std::size_t i = 0; i < pngs.size(); ++i) {
    bool begun = false;
    for (PngChunk& chunk : png_chunks(pngs[i], "frame " + std::to_string(i))) {
      if (chunk.type == "IHDR") size = chunk.data.substr(0, 8);
      if (chunk.type == "IDAT" && !begun) {
        begun = true;
        const auto count = static_cast<std::uint32_t>(pngs.size());
        if (i == 0) all.push_back({"acTL", big_endian(count) + big_endian(0)});
        all.push_back(frame_control(sequence++, size, milliseconds));
      }
      if (i == 0 && chunk.type != "IEND")
        all.push_back(std::move(chunk));
      else if (i > 0 && chunk.type == "IDAT")
        all.push_back({"fdAT", big_endian(sequence++) + chunk.data});
    }
  }
  all.push_back({"IEND", {}});
  return join_chunks(all);
}

}  // namespace planescope::draw
