// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_links.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <numeric>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace planescope {
namespace {

using Row = std::uint64_t;

// The 27 blocks around each of a run of blocks in turn: nine cursors, one for each row of three
// blocks, move over the sorted keys; nothing is hashed.
class BlockCursors {
 public:
  BlockCursors(const VoxelBlocks& blocks, std::size_t first) : blocks_(blocks) {
    for (std::size_t row = 0; row < 9; ++row) {
      const std::int64_t left = blocks.keys[first] + offset(row);
      const auto at = std::lower_bound(blocks.keys.begin(), blocks.keys.end(), left);
      cursors_[row] = static_cast<std::size_t>(at - blocks.keys.begin());
    }
  }

  // Calls visit(z, y, x, block) with z, y, x in 0 .. 2 for the blocks there are around block b; b
  // never goes back.
  template <typename Visit>
  void around(std::size_t b, Visit&& visit) {
    for (std::size_t row = 0; row < 9; ++row) {
      const std::int64_t left = blocks_.keys[b] + offset(row);
      std::size_t& c = cursors_[row];
      while (c < blocks_.keys.size() && blocks_.keys[c] < left) ++c;
      for (std::size_t i = c; i < blocks_.keys.size() && blocks_.keys[i] <= left + 2; ++i) {
        visit(row / 3, row % 3, static_cast<std::size_t>(blocks_.keys[i] - left),
              blocks_.blocks[i]);
      }
    }
  }

 private:
  static std::int64_t offset(std::size_t row) {
    const auto z = static_cast<std::int64_t>(row / 3), y = static_cast<std::int64_t>(row % 3);
    return block_key(-1, y - 1, z - 1);
  }

  const VoxelBlocks& blocks_;
  std::array<std::size_t, 9> cursors_;
};

// One block and the ring of cells around it: 10 x 10 rows of 10 cells. Bit 0 of a row lies in the
// block to the left, bits 1 to 8 in the middle, bit 9 in the block to the right.
struct Halo {
  struct Numbers {
    std::uint32_t left, middle, right;  // of the row's first voxel in each of the three blocks
  };
  std::array<std::uint16_t, 100> rows;
  std::array<Numbers, 100> numbers;  // only where the row has voxels there

  static std::size_t row(std::size_t z, std::size_t y) { return z * 10 + y; }

  void gather(BlockCursors& cursors, std::size_t b) {
    rows.fill(0);
    cursors.around(b, [&](std::size_t z, std::size_t y, std::size_t x, const VoxelBlock& block) {
      constexpr std::array<std::size_t, 3> kFirst = {7, 0, 0}, kLast = {7, 7, 0}, kTo = {0, 1, 9};
      constexpr std::array<std::uint64_t, 3> kRows = {0xFF00000000000000u, ~std::uint64_t{0},
                                                      0xFFu};
      constexpr std::array<std::uint64_t, 3> kColumns = {0x8080808080808080u, ~std::uint64_t{0},
                                                         0x0101010101010101u};
      for (std::size_t word = kFirst[z]; word <= kLast[z]; ++word) {
        const std::uint64_t bits = block.bits[word];
        for (std::uint64_t rest = bits & kRows[y] & kColumns[x]; rest != 0;) {
          const auto at = static_cast<unsigned>(std::countr_zero(rest));
          const unsigned line = at / 8;
          const std::size_t to = row(kTo[z] + word - kFirst[z], kTo[y] + line - kFirst[y]);
          const std::uint32_t number = block.rank(static_cast<unsigned>(word) * 64 + at);
          const std::uint64_t line_bits = bits >> (8 * line) & 0xFF;
          if (x == 0) rows[to] |= 1, numbers[to].left = number;
          if (x == 1) {
            rows[to] = static_cast<std::uint16_t>(rows[to] | line_bits << 1);
            numbers[to].middle = number;
          }
          if (x == 2) rows[to] |= 1 << 9, numbers[to].right = number;
          rest &= ~(std::uint64_t{0xFF} << (8 * line));
        }
      }
    });
  }
};

// Calls visit(voxel, z, y, x) for each voxel of a block, in their order.
template <typename Visit>
void for_each_cell(const VoxelBlock& block, Visit&& visit) {
  std::uint32_t voxel = block.base;
  for (std::size_t z = 0; z < 8; ++z) {
    for (std::uint64_t bits = block.bits[z]; bits != 0; bits &= bits - 1) {
      const auto cell = static_cast<unsigned>(std::countr_zero(bits));
      visit(voxel++, z, std::size_t{cell / 8}, cell % 8);
    }
  }
}

std::uint32_t count_neighbours(const Halo& halo, std::size_t z, std::size_t y, unsigned x) {
  std::uint64_t near = 0;
  for (std::size_t k = 0; k < 9; ++k) {
    const std::uint64_t row = halo.rows[Halo::row(z + k / 3, y + k % 3)];
    near |= (row >> x & 7) << (3 * k);
  }
  return static_cast<std::uint32_t>(std::popcount(near)) - 1;  // without itself
}

// Writes the neighbours of a voxel in their order. \returns the end; up to two numbers behind it
// are overwritten.
std::uint32_t* write_neighbours(const Halo& halo, std::uint32_t voxel, std::size_t z, std::size_t y,
                                unsigned x, std::uint32_t* out) {
  const auto put = [&out](std::uint32_t number, bool there) {
    *out = number;
    out += there ? 1 : 0;
  };
  for (std::size_t k = 0; k < 9; ++k) {
    const std::size_t at = Halo::row(z + k / 3, y + k % 3);
    const unsigned row = halo.rows[at], near = row >> x & 7;
    if (near == 0) continue;
    const Halo::Numbers& numbers = halo.numbers[at];
    if (k == 4) {  // its own row
      put(x == 0 ? numbers.left : voxel - 1, (near & 1) != 0);
      put(x == 7 ? numbers.right : voxel + 1, (near & 4) != 0);
      continue;
    }
    if (x == 0) put(numbers.left, (near & 1) != 0);
    const unsigned middle = row & 0x1FE;
    const std::uint32_t first =
        numbers.middle + static_cast<std::uint32_t>(std::popcount(middle & ((1u << x) - 1)));
    out[0] = first, out[1] = first + 1, out[2] = first + 2;  // those that are not there: for now
    out += std::popcount(middle >> x & 7);
    if (x == 7) put(numbers.right, (near & 4) != 0);
  }
  return out;
}

// Calls body(halo, block) for each block, with its surroundings.
template <typename Body>
void for_each_block(const VoxelBlocks& blocks, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.blocks.size(), 32),
                    [&](const auto& range) {
                      BlockCursors cursors(blocks, range.begin());
                      Halo halo;
                      for (std::size_t b = range.begin(); b != range.end(); ++b) {
                        halo.gather(cursors, b);
                        body(halo, blocks.blocks[b]);
                      }
                    });
}

}  // namespace

void link_voxels(const VoxelBlocks& blocks, VoxelGrid& grid) {
  std::vector<std::uint32_t>& offsets = grid.neighbour_offsets;
  offsets.assign(blocks.voxel_count + std::size_t{1}, 0);
  for_each_block(blocks, [&](const Halo& halo, const VoxelBlock& block) {
    for_each_cell(block, [&](std::uint32_t voxel, std::size_t z, std::size_t y, unsigned x) {
      offsets[voxel + std::size_t{1}] = count_neighbours(halo, z, y, x);
    });
  });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  grid.neighbours.resize(offsets.back());
  for_each_block(blocks, [&](const Halo& halo, const VoxelBlock& block) {
    std::array<std::uint32_t, 30> row;
    for_each_cell(block, [&](std::uint32_t voxel, std::size_t z, std::size_t y, unsigned x) {
      std::uint32_t* end = write_neighbours(halo, voxel, z, y, x, row.data());
      std::copy(row.data(), end, grid.neighbours.data() + offsets[voxel]);
    });
  });
}

}  // namespace planescope
