// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace planescope {

/// 64-bit FNV-1a in 8-byte little-endian steps, the tail byte by byte. Every piece but the last
/// must be a multiple of 8 bytes long.
class FileHash {
 public:
  void add(std::string_view piece);
  /// 16 hexadecimal digits.
  std::string hex() const;

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;  // FNV's offset basis
};

}  // namespace planescope
