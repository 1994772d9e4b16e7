// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "planescope/result.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;
using testing::write_bytes;

/// One step of FNV-1a, its prime 2^40 + 0x1b3 = 2^40 + 2^8 + 2^7 + 2^5 + 2^4 + 3 taken bit by bit.
std::uint64_t fnv(std::uint64_t state, std::uint64_t word) {
  const std::uint64_t x = state ^ word;
  return (x << 40) + (x << 8) + (x << 7) + (x << 5) + (x << 4) + x * 3;
}

TEST(HashFile, IsFnv1aInEightByteSteps) {
  const TemporaryFolder folder;
  const auto hash = [&](const std::string& bytes) {
    write_bytes(folder / "f", bytes);
    return hash_file(folder / "f");
  };
  const auto hex = [](std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return std::string(text);
  };
  EXPECT_EQ(hash(""), "cbf29ce484222325");   // FNV's offset basis
  EXPECT_EQ(hash("a"), "af63dc4c8601ec8c");  // published FNV-1a test vector
  EXPECT_EQ(hash("foobar"), "85944171f73967e8");
  const std::uint64_t word = 0x6867666564636261;  // "abcdefgh", little-endian
  EXPECT_EQ(hash("abcdefgh"), hex(fnv(0xcbf29ce484222325, word)));
  EXPECT_EQ(hash("abcdefgha"), hex(fnv(fnv(0xcbf29ce484222325, word), 'a')));
  EXPECT_NE(hash("a"), hash(std::string("a\0", 2)));
  EXPECT_THROW(hash_file(folder / "none"), Error);
}

TEST(HashFile, LongFilesAreReadInPieces) {
  const TemporaryFolder folder;
  std::string bytes((std::size_t{3} << 20) + 5, 'x');
  write_bytes(folder / "f", bytes);
  std::uint64_t state = 0xcbf29ce484222325;
  for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) state = fnv(state, 0x7878787878787878);
  for (int i = 0; i < 5; ++i) state = fnv(state, 'x');
  EXPECT_EQ(std::stoull(hash_file(folder / "f"), nullptr, 16), state);
}

}  // namespace
}  // namespace planescope
