// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "planescope/error.hpp"
#include "planescope/result.hpp"

namespace planescope {
namespace {

/// 64-bit FNV-1a in 8-byte little-endian steps, the tail byte by byte. Every piece but the last
/// must be a multiple of 8 bytes long.
std::uint64_t add(std::uint64_t state, std::string_view piece) {
  constexpr std::uint64_t kPrime = 0x100000001b3u;
  std::size_t at = 0;
  for (; at + 8 <= piece.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, piece.data() + at, 8);
    state = (state ^ word) * kPrime;
  }
  for (; at < piece.size(); ++at) {
    state = (state ^ static_cast<unsigned char>(piece[at])) * kPrime;
  }
  return state;
}

std::string hex(std::uint64_t state) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state));
  return text;
}

constexpr std::uint64_t kBasis = 0xcbf29ce484222325u;  // FNV's offset basis

}  // namespace

std::string hash_text(std::string_view text) { return hex(add(kBasis, text)); }

std::string hash_file(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                           &std::fclose);
  const auto fail = [&] {
    throw Error(Error::Kind::Input, file.string() + ": cannot be read: " + std::strerror(errno));
  };
  if (!in) fail();
  std::uint64_t state = kBasis;
  std::vector<char> piece(std::size_t{1} << 20);
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), in.get())) {
    state = add(state, {piece.data(), got});
  }
  if (std::ferror(in.get()) != 0) fail();
  return hex(state);
}

}  // namespace planescope
