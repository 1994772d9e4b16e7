// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

/// \file Random numbers that are the same with every standard library: only the engine's output is
/// portable, the distributions of <random> are not.
namespace planescope {

/// A uniform integer in [0, n); n at most 2^32.
inline std::uint64_t uniform_index(std::mt19937_64& random, std::uint64_t n) {
  return ((random() >> 32) * n) >> 32;
}

/// A uniform number in [0, 1) with 53 random bits.
inline double uniform_unit(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace planescope
