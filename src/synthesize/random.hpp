// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace planescope::synthesis {

/// A small seeded generator (SplitMix64; Steele, Lea and Flood, OOPSLA 2014) with its own
/// distributions: those of the standard library may differ from one implementation to the next.
/// Eight bytes of state, so that every chunk of points can have one of its own and the number of
/// threads does not matter.
class Random {
 public:
  /// \param stream names what the numbers are for; each stream of a seed is independent.
  explicit Random(std::uint64_t seed, std::initializer_list<std::uint64_t> stream = {})
      : state_(mix(seed + kStep)) {
    for (const std::uint64_t part : stream) state_ = mix(state_ ^ mix(part + kStep));
  }

  std::uint64_t next() { return mix(state_ += kStep); }

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// In {low, ..., high}.
  int integer(int low, int high) {
    return low + static_cast<int>(uniform() * static_cast<double>(high - low + 1));
  }

  bool chance(double probability) { return uniform() < probability; }

  /// Standard normal (Box and Muller 1958); every second call uses the first one's other half.
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    const double angle = 2.0 * std::numbers::pi * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace planescope::synthesis
