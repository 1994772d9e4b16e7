// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_hash.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "planescope/error.hpp"
#include "planescope/result.hpp"

namespace planescope {

void FileHash::add(std::string_view piece) {
  constexpr std::uint64_t kPrime = 0x100000001b3u;
  std::size_t at = 0;
  for (; at + 8 <= piece.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, piece.data() + at, 8);
    state_ = (state_ ^ word) * kPrime;
  }
  for (; at < piece.size(); ++at) {
    state_ = (state_ ^ static_cast<unsigned char>(piece[at])) * kPrime;
  }
}

std::string FileHash::hex() const {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state_));
  return text;
}

std::string hash_file(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"),
                                                           &std::fclose);
  const auto fail = [&] {
    throw Error(Error::Kind::Input, file.string() + ": cannot be read: " + std::strerror(errno));
  };
  if (!in) fail();
  FileHash hash;
  std::vector<char> piece(std::size_t{1} << 20);
  while (const std::size_t got = std::fread(piece.data(), 1, piece.size(), in.get())) {
    hash.add({piece.data(), got});
  }
  if (std::ferror(in.get()) != 0) fail();
  return hash.hex();
}

}  // namespace planescope
