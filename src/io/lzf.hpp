// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

/// \file The LZF format, as binary_compressed PCD files use it.
namespace planescope::io {

/// The most that LZF can expand: 3 bytes (control, length, distance) name at most 264 bytes. A file
/// that claims more is refused before anything is allocated for it.
inline constexpr std::uint64_t kLzfLargestRatio = 88;

/// Why a stream is not LZF, and where in it.
struct LzfFailure {
  std::size_t offset = 0;  ///< [byte] in the compressed stream
  std::string what;
};

/// Expands `from` so that it fills `to` exactly; the failure where it does not. The stream is a
/// sequence of
/// - 000LLLLL, then L+1 literal bytes;
/// - LLLddddd dddddddd (0 < LLL < 7): L+2 bytes, copied from d+1 bytes back in the output;
/// - 111ddddd LLLLLLLL dddddddd: L+9 bytes, likewise. Source and target of a copy may overlap.
std::optional<LzfFailure> lzf_expand(std::span<const std::byte> from, std::span<std::byte> to);

}  // namespace planescope::io
