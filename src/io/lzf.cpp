// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/lzf.hpp"

#include <cstring>

namespace planescope::io {
namespace {

/// Copies `size` bytes from `distance` back to `to`; where they overlap, what was just written is
/// copied again, which is how LZF stores runs.
void copy_back(std::byte* to, std::size_t distance, std::size_t size) noexcept {
  const std::byte* from = to - distance;
  if (distance >= size) {
    std::memcpy(to, from, size);
  } else {
    for (std::size_t i = 0; i < size; ++i) to[i] = from[i];
  }
}

}  // namespace

std::optional<LzfFailure> lzf_expand(std::span<const std::byte> from, std::span<std::byte> to) {
  std::size_t in = 0, out = 0;
  while (in < from.size()) {
    const std::size_t start = in;
    const auto control = static_cast<std::size_t>(from[in++]);
    const std::size_t room = to.size() - out;
    if (control < 32) {
      const std::size_t size = control + 1;
      if (size > from.size() - in) return LzfFailure{start, "the stream ends inside a literal run"};
      if (size > room) return LzfFailure{start, "the data expand beyond the size in the header"};
      std::memcpy(to.data() + out, from.data() + in, size);
      in += size;
      out += size;
      continue;
    }
    std::size_t size = (control >> 5) + 2;
    const std::size_t operands = size == 9 ? 2 : 1;
    if (operands > from.size() - in) return LzfFailure{start, "the stream ends inside a copy"};
    if (operands == 2) size += static_cast<std::size_t>(from[in++]);
    const std::size_t distance = ((control & 31) << 8) + static_cast<std::size_t>(from[in++]) + 1;
    if (distance > out) return LzfFailure{start, "a copy reaches back before the first byte"};
    if (size > room) return LzfFailure{start, "the data expand beyond the size in the header"};
    copy_back(to.data() + out, distance, size);
    out += size;
  }
  if (out == to.size()) return std::nullopt;
  return LzfFailure{in, "the data expand to " + std::to_string(out) + " bytes, not the " +
                            std::to_string(to.size()) + " of the header"};
}

}  // namespace planescope::io
