// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "planescope/fusion.hpp"

namespace planescope::fusion {

inline constexpr int kSide = 8;  ///< [voxel] of a block
inline constexpr int kVoxels = kSide * kSide * kSide;
inline constexpr std::int32_t kReach = 1 << 20;  ///< [block] keys are smaller than this

/// Voxels of a block, index (z * 8 + y) * 8 + x; a voxel's value is that of its corner of least
/// x, y, z.
struct Block {
  BlockKey key;
  std::int64_t changed = -1;                 ///< last frame that changed it; -1: none
  bool behind = false;                       ///< a distance may be negative: there may be a surface
  std::array<float, kVoxels> distance{};     ///< [truncation] in [-1, 1]; positive: seen through
  std::array<float, kVoxels> weight{};       ///< 0: never seen
  std::array<std::uint8_t, kVoxels> seen{};  ///< frames that saw it, at most 255
  std::array<float, kVoxels> color_weight{};                  ///< 0: no colour
  std::array<std::array<std::uint16_t, 3>, kVoxels> color{};  ///< [1/256] so that means settle
};

/// Weight of a return at `depth` [m], by its variance: structured light's standard deviation of
/// 1.4 mm z^2 (Khoshelham and Elberink, Sensors 2012) beside 3 mm of poses and calibration.
inline float frame_weight(float depth) noexcept {
  constexpr float kEqual = 1.46f;  // [m] where both are the same
  const float square = depth * depth / (kEqual * kEqual);
  return 1 / (1 + square * square);
}

/// A key as one number, ascending by (z, y, x).
inline std::uint64_t pack(const BlockKey& key) noexcept {
  const auto part = [](std::int32_t v) {
    return static_cast<std::uint64_t>(v + kReach) & 0x1FFFFF;
  };
  return part(key.z) << 42 | part(key.y) << 21 | part(key.x);
}

inline BlockKey unpack(std::uint64_t packed) noexcept {
  const auto part = [&](int shift) {
    return static_cast<std::int32_t>(packed >> shift & 0x1FFFFF) - kReach;
  };
  return {part(0), part(21), part(42)};
}

/// All blocks, found by key.
class BlockMap {
 public:
  const Block* find(const BlockKey& key) const {
    const auto found = index_.find(pack(key));
    return found == index_.end() ? nullptr : blocks_[found->second].get();
  }

  Block& make(std::uint64_t packed) {
    const auto [entry, added] = index_.try_emplace(packed, blocks_.size());
    if (added) {
      blocks_.push_back(std::make_unique<Block>());
      blocks_.back()->key = unpack(packed);
    }
    return *blocks_[entry->second];
  }

  std::size_t size() const noexcept { return blocks_.size(); }
  /// In the order of their making.
  const std::vector<std::unique_ptr<Block>>& blocks() const noexcept { return blocks_; }
  /// By key.
  std::vector<const Block*> sorted() const;

 private:
  std::unordered_map<std::uint64_t, std::size_t> index_;
  std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace planescope::fusion

namespace planescope {

struct TsdfVolume::Field {
  FusionOptions options;
  fusion::BlockMap blocks;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::uint32_t frames = 0;
  bool colored = false;  ///< a frame had colours

  /// Frames that must have seen a voxel.
  std::uint32_t least() const noexcept {
    if (options.min_observations > 0) return options.min_observations;
    return frames < 10 ? 1 : 3;
  }
};

}  // namespace planescope
