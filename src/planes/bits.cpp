// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/bits.hpp"

#include <algorithm>
#include <cstddef>

namespace planescope {
namespace {

/// The number of set bits of each byte, in that byte.
std::uint64_t byte_counts(std::uint64_t v) {
  v -= (v >> 1) & 0x5555555555555555u;
  v = (v & 0x3333333333333333u) + ((v >> 2) & 0x3333333333333333u);
  return (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0fu;
}

std::uint32_t sum_of_bytes(std::uint64_t v) {
  v = (v & 0x00ff00ff00ff00ffu) + ((v >> 8) & 0x00ff00ff00ff00ffu);
  return static_cast<std::uint32_t>((v * 0x0001000100010001u) >> 48);
}

/// Sums word(0) .. word(words - 1) bit by bit. Without a popcount instruction (baseline x86-64 has
/// none) this form is the fast one, because the compiler turns the inner loop into vectors.
template <typename Word>
std::uint32_t count_words(std::size_t words, Word word) {
  constexpr std::size_t kRun = 31;  // 31 * 8 bits is the most that a byte can count
  std::uint32_t total = 0;
  for (std::size_t begin = 0; begin < words; begin += kRun) {
    const std::size_t end = std::min(begin + kRun, words);
    std::uint64_t sums = 0;
    for (std::size_t w = begin; w < end; ++w) sums += byte_counts(word(w));
    total += sum_of_bytes(sums);
  }
  return total;
}

}  // namespace

std::uint32_t count(const Bits& set) {
  return count_words(set.size(), [p = set.data()](std::size_t w) { return p[w]; });
}

std::uint32_t count_common(const Bits& a, const Bits& b) {
  return count_words(a.size(), [p = a.data(), q = b.data()](std::size_t w) { return p[w] & q[w]; });
}

bool any_common(const Bits& a, const Bits& b) {
  for (std::size_t w = 0; w < a.size(); ++w) {
    if ((a[w] & b[w]) != 0) return true;
  }
  return false;
}

}  // namespace planescope
