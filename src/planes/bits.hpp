// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

/// \file Sets of patches as bits: element i is bit i % 64 of word i / 64.
namespace planescope {

using Bits = std::vector<std::uint64_t>;

/// Number of elements.
std::uint32_t count(const Bits& set);

/// Number of elements in both; the sets have equally many words.
std::uint32_t count_common(const Bits& a, const Bits& b);

/// True if some element is in both; the sets have equally many words.
bool any_common(const Bits& a, const Bits& b);

inline bool contains(const Bits& set, std::size_t i) {
  return ((set[i / 64] >> (i % 64)) & 1) != 0;
}

inline void insert(Bits& set, std::size_t i) { set[i / 64] |= std::uint64_t{1} << (i % 64); }

/// Calls visit(i) for each element, ascending.
template <typename Visit>
void for_each(const Bits& set, Visit visit) {
  for (std::size_t w = 0; w < set.size(); ++w) {
    for (std::uint64_t rest = set[w]; rest != 0; rest &= rest - 1) {
      visit(w * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
    }
  }
}

}  // namespace planescope
