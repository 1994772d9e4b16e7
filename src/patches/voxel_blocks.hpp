// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace planescope {

/// 8 x 8 x 8 voxels as bits: the set bits are the occupied voxels, numbered through from `base`. A
/// voxel is found by rank, so a block costs 84 bytes however many voxels it holds, and voxels of
/// one block lie together in memory.
struct VoxelBlock {
  std::array<std::uint64_t, 8> bits{};    ///< word z, bit 8 y + x
  std::array<std::uint16_t, 8> before{};  ///< set bits in the words below
  std::uint32_t base = 0;                 ///< number of the block's first voxel

  bool contains(unsigned cell) const { return (bits[cell >> 6] >> (cell & 63) & 1) != 0; }
  /// Number of the voxel in `cell` (z 64 + y 8 + x); only where contains(cell).
  std::uint32_t rank(unsigned cell) const {
    const std::uint64_t below = bits[cell >> 6] & ((std::uint64_t{1} << (cell & 63)) - 1);
    return base + before[cell >> 6] + static_cast<std::uint32_t>(std::popcount(below));
  }
};

/// The occupied blocks of a grid, by key.
struct VoxelBlocks {
  std::vector<std::int64_t> keys;  ///< ascending: z, then y, then x
  std::vector<VoxelBlock> blocks;
  std::uint32_t voxel_count = 0;
};

inline constexpr unsigned kAxisBits = 21;              ///< voxels along an axis: at most 2^21
inline constexpr unsigned kBlockBits = kAxisBits - 3;  ///< blocks along an axis

/// Key of the block at (x, y, z), each within -1 and 2^kBlockBits - 1.
constexpr std::int64_t block_key(std::int64_t x, std::int64_t y, std::int64_t z) {
  return (z * (std::int64_t{1} << kBlockBits) + y) * (std::int64_t{1} << kBlockBits) + x;
}

/// Open-addressing hash from block key to index; keys are never removed.
class BlockMap {
 public:
  static constexpr std::uint32_t kAbsent = 0xFFFFFFFFu;

  explicit BlockMap(std::size_t expected = 64);
  /// Index of `key`, which is inserted with the next free index if absent.
  std::uint32_t insert(std::uint64_t key);
  /// Index of `key`, or kAbsent.
  std::uint32_t find(std::uint64_t key) const;
  const std::vector<std::uint64_t>& keys() const { return keys_; }  ///< by index

 private:
  std::size_t slot(std::uint64_t key) const;
  void grow();

  std::vector<std::uint32_t> table_;  // index + 1; 0: free
  std::vector<std::uint64_t> keys_;
  std::size_t mask_;
};

}  // namespace planescope
