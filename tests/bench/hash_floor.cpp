// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "hash_floor.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace planescope::bench {
namespace {

constexpr std::uint64_t kEmpty = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kAhead = 8;  // points between computing a key and looking it up

struct Slot {
  std::uint64_t key = kEmpty;
  std::uint32_t voxel = 0;
};

/// Keys of 21 bits an axis around the origin; `kEmpty` for a non-finite point.
std::uint64_t key_of(const Eigen::Vector3f& point, float inverse) {
  if (!is_finite(point)) return kEmpty;
  const auto bits = [inverse](float v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v * inverse)) +
                                      (1 << 20)) &
           0x1fffff;
  };
  return bits(point.x()) << 42 | bits(point.y()) << 21 | bits(point.z());
}

}  // namespace

std::vector<std::uint32_t> hash_pass(const PointCloud& cloud, double voxel_size) {
  const auto inverse = static_cast<float>(1.0 / voxel_size);
  // As many slots as points: at the densities of a room, voxels fill a small part of them.
  std::vector<Slot> table(std::bit_ceil(cloud.size() + 1));
  const std::size_t mask = table.size() - 1;
  const int shift = 64 - std::countr_zero(table.size());
  const auto home = [shift](std::uint64_t key) {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> shift);
  };
  std::vector<std::uint32_t> voxel(cloud.size(), std::numeric_limits<std::uint32_t>::max());
  std::array<std::uint64_t, kAhead> waiting;
  waiting.fill(kEmpty);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < cloud.size() + kAhead; ++i) {
    const std::uint64_t key = waiting[i % kAhead];
    if (key != kEmpty) {
      std::size_t at = home(key);
      while (table[at].key != key && table[at].key != kEmpty) at = (at + 1) & mask;
      if (table[at].key == kEmpty) table[at] = {key, count++};
      voxel[i - kAhead] = table[at].voxel;
    }
    waiting[i % kAhead] = i < cloud.size() ? key_of(cloud.positions[i], inverse) : kEmpty;
    if (waiting[i % kAhead] != kEmpty) __builtin_prefetch(&table[home(waiting[i % kAhead])], 1);
  }
  return voxel;
}

}  // namespace planescope::bench
