// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_grid.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "patches/grid_bounds.hpp"
#include "patches/voxel_blocks.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t kGrain = 16384;
constexpr unsigned kAxisBits = 21;              // voxels along an axis: at most 2^21
constexpr unsigned kBlockBits = kAxisBits - 3;  // blocks along an axis
constexpr std::uint64_t kBlockMask = (1u << kBlockBits) - 1;

// Which block and which cell of it a point falls into.
struct Address {
  std::uint64_t block;
  unsigned cell;
};

struct Addressing {
  GridBounds bounds;
  float inverse;

  Address operator()(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f scaled =
        (p - bounds.lower) * inverse;  // never negative: truncation is floor
    const auto x = static_cast<std::uint32_t>(scaled.x());
    const auto y = static_cast<std::uint32_t>(scaled.y());
    const auto z = static_cast<std::uint32_t>(scaled.z());
    return {
        std::uint64_t{z >> 3} << (2 * kBlockBits) | std::uint64_t{y >> 3} << kBlockBits | (x >> 3),
        (z & 7) << 6 | (y & 7) << 3 | (x & 7)};
  }
};

Addressing make_addressing(const PointCloud& cloud, double voxel_size) {
  const double longest = (double(1u << kAxisBits) - 8) * voxel_size;
  const GridBounds bounds = find_grid_bounds(cloud, longest);
  if (!(bounds.extent() < longest)) {
    std::ostringstream message;
    message << "the cloud spans " << bounds.extent() << " m, more than " << (1u << kAxisBits)
            << " voxels of " << voxel_size << " m; remove outliers or choose a larger --voxel-size";
    throw Error(Error::Kind::Computation, message.str());
  }
  return {bounds, static_cast<float>(1.0 / voxel_size)};
}

// The set of occupied cells: its union over threads does not depend on how points were dealt out.
struct Occupancy {
  BlockMap map;
  std::vector<std::array<std::uint64_t, 8>> bits;

  std::array<std::uint64_t, 8>& block(std::uint64_t key) {
    const std::uint32_t index = map.insert(key);
    if (index == bits.size()) bits.push_back({});
    return bits[index];
  }
};

Occupancy find_occupied(const PointCloud& cloud, const Addressing& address) {
  tbb::combinable<Occupancy> local;
  tbb::parallel_for(Range(0, cloud.size(), kGrain), [&](const Range& range) {
    Occupancy& mine = local.local();
    std::uint64_t last_key = ~std::uint64_t{0};
    std::array<std::uint64_t, 8>* last = nullptr;  // scans stay in a block for several points
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (!address.bounds.takes(cloud.positions[i])) continue;
      const Address at = address(cloud.positions[i]);
      if (at.block != last_key) {
        last = &mine.block(at.block);
        last_key = at.block;
      }
      (*last)[at.cell >> 6] |= std::uint64_t{1} << (at.cell & 63);
    }
  });
  Occupancy all;
  bool first = true;
  local.combine_each([&](Occupancy& part) {
    if (std::exchange(first, false)) {
      all = std::move(part);
      return;
    }
    for (std::size_t b = 0; b < part.bits.size(); ++b) {
      auto& bits = all.block(part.map.keys()[b]);
      for (std::size_t w = 0; w < 8; ++w) bits[w] |= part.bits[b][w];
    }
  });
  return all;
}

struct Blocks {
  BlockMap map;
  std::vector<VoxelBlock> blocks;  // by index in map, which is in the order of keys
  std::uint32_t voxel_count = 0;
};

Blocks number_voxels(const Occupancy& occupied) {
  const std::vector<std::uint64_t>& keys = occupied.map.keys();
  std::vector<std::uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return keys[a] < keys[b]; });
  Blocks result{BlockMap(keys.size()), std::vector<VoxelBlock>(keys.size()), 0};
  for (std::size_t b = 0; b < order.size(); ++b) {
    result.map.insert(keys[order[b]]);
    VoxelBlock& block = result.blocks[b];
    block.bits = occupied.bits[order[b]];
    block.base = result.voxel_count;
    std::uint16_t before = 0;
    for (std::size_t w = 0; w < 8; ++w) {
      block.before[w] = before;
      before = static_cast<std::uint16_t>(before + std::popcount(block.bits[w]));
    }
    result.voxel_count += before;
  }
  return result;
}

void locate_points(const PointCloud& cloud, const Addressing& address, const Blocks& blocks,
                   VoxelGrid& grid) {
  grid.point_voxel.resize(cloud.size());
  tbb::parallel_for(Range(0, cloud.size(), kGrain), [&](const Range& range) {
    std::uint64_t last_key = ~std::uint64_t{0};
    const VoxelBlock* last = nullptr;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (!address.bounds.takes(cloud.positions[i])) {
        grid.point_voxel[i] = kNoVoxel;
        continue;
      }
      const Address at = address(cloud.positions[i]);
      if (at.block != last_key) {
        last = &blocks.blocks[blocks.map.find(at.block)];
        last_key = at.block;
      }
      grid.point_voxel[i] = last->rank(at.cell);
    }
  });
}

// Each voxel's sums run over its points in the cloud's order, whichever thread does it: every task
// reads all of point_voxel and adds up the voxels of its own range only. Sums are double: a million
// equal points stay exact.
void average_points(const PointCloud& cloud, VoxelGrid& grid, std::size_t voxel_count,
                    bool with_color) {
  grid.mean.resize(voxel_count);
  grid.point_count.assign(voxel_count, 0);
  if (with_color) grid.color.resize(voxel_count);
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t tasks = std::clamp<std::size_t>(threads, 1, 8);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    const std::size_t begin = voxel_count * task / tasks, end = voxel_count * (task + 1) / tasks;
    std::vector<Eigen::Vector3d> sums(end - begin, Eigen::Vector3d::Zero());
    std::vector<Eigen::Vector3f> colors(with_color ? end - begin : 0, Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::size_t voxel = grid.point_voxel[i];
      if (voxel < begin || voxel >= end) continue;
      sums[voxel - begin] += cloud.positions[i].cast<double>();
      ++grid.point_count[voxel];
      if (with_color) {
        const Rgb& c = cloud.colors[i];
        colors[voxel - begin] += Eigen::Vector3f(c.r, c.g, c.b);
      }
    }
    for (std::size_t voxel = begin; voxel < end; ++voxel) {
      grid.mean[voxel] = (sums[voxel - begin] / grid.point_count[voxel]).cast<float>();
      if (with_color) grid.color[voxel] = colors[voxel - begin] / float(grid.point_count[voxel]);
    }
  });
}

// The 27 blocks around each block, so that neighbours are found without hashing.
using Neighbourhood = std::array<std::uint32_t, 27>;

std::vector<Neighbourhood> link_blocks(const Blocks& blocks) {
  std::vector<Neighbourhood> around(blocks.blocks.size());
  tbb::parallel_for(std::size_t{0}, around.size(), [&](std::size_t b) {
    const std::uint64_t key = blocks.map.keys()[b];
    const auto x = static_cast<std::int64_t>(key & kBlockMask);
    const auto y = static_cast<std::int64_t>(key >> kBlockBits & kBlockMask);
    const auto z = static_cast<std::int64_t>(key >> (2 * kBlockBits));
    const auto limit = static_cast<std::int64_t>(kBlockMask);
    for (int i = 0; i < 27; ++i) {
      const std::int64_t nx = x + i % 3 - 1, ny = y + i / 3 % 3 - 1, nz = z + i / 9 - 1;
      const bool inside =
          nx >= 0 && ny >= 0 && nz >= 0 && nx <= limit && ny <= limit && nz <= limit;
      around[b][static_cast<std::size_t>(i)] =
          inside ? blocks.map.find(static_cast<std::uint64_t>(nz) << (2 * kBlockBits) |
                                   static_cast<std::uint64_t>(ny) << kBlockBits |
                                   static_cast<std::uint64_t>(nx))
                 : BlockMap::kAbsent;
    }
  });
  return around;
}

// Calls visit(block, word, bits of the row) for the nine rows of up to three voxels around `cell`;
// where the row leaves the block along x it comes in two parts. `bits` are in place within the
// word.
template <typename Visit>
void for_each_row(const Blocks& blocks, const Neighbourhood& around, unsigned cell, Visit&& visit) {
  const int x = static_cast<int>(cell & 7), y = static_cast<int>(cell >> 3 & 7),
            z = static_cast<int>(cell >> 6);
  const std::uint64_t window = x == 0 ? 0b11u : std::uint64_t{0b111} << (x - 1) & 0xFF;
  const auto visit_row = [&](int bx, int ny, int nz, std::uint64_t columns) {
    const int by = ny < 0 ? 0 : (ny > 7 ? 2 : 1), bz = nz < 0 ? 0 : (nz > 7 ? 2 : 1);
    const std::uint32_t index = around[static_cast<std::size_t>(bz * 9 + by * 3 + bx)];
    if (index == BlockMap::kAbsent) return;
    const auto word = static_cast<unsigned>(nz & 7);
    const VoxelBlock& block = blocks.blocks[index];
    const std::uint64_t bits = block.bits[word] & columns << (8 * (ny & 7));
    if (bits != 0) visit(block, word, bits);
  };
  for (int nz = z - 1; nz <= z + 1; ++nz) {
    for (int ny = y - 1; ny <= y + 1; ++ny) {
      if (x == 0) visit_row(0, ny, nz, std::uint64_t{1} << 7);
      visit_row(1, ny, nz, window);
      if (x == 7) visit_row(2, ny, nz, 1);
    }
  }
}

template <typename Visit>
void for_each_cell(const VoxelBlock& block, Visit&& visit) {
  std::uint32_t voxel = block.base;
  for (unsigned word = 0; word < 8; ++word) {
    for (std::uint64_t bits = block.bits[word]; bits != 0; bits &= bits - 1) {
      visit(voxel++, word << 6 | static_cast<unsigned>(std::countr_zero(bits)));
    }
  }
}

void link_voxels(const Blocks& blocks, VoxelGrid& grid) {
  const std::vector<Neighbourhood> around = link_blocks(blocks);
  grid.neighbour_offsets.assign(blocks.voxel_count + std::size_t{1}, 0);
  const Range all(0, blocks.blocks.size(), 64);
  tbb::parallel_for(all, [&](const Range& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b) {
      for_each_cell(blocks.blocks[b], [&](std::uint32_t voxel, unsigned cell) {
        int count = -1;  // without itself
        for_each_row(blocks, around[b], cell, [&](const VoxelBlock&, unsigned, std::uint64_t bits) {
          count += std::popcount(bits);
        });
        grid.neighbour_offsets[voxel + std::size_t{1}] = static_cast<std::uint32_t>(count);
      });
    }
  });
  std::partial_sum(grid.neighbour_offsets.begin(), grid.neighbour_offsets.end(),
                   grid.neighbour_offsets.begin());
  grid.neighbours.resize(grid.neighbour_offsets.back());
  tbb::parallel_for(all, [&](const Range& range) {
    for (std::size_t b = range.begin(); b != range.end(); ++b) {
      for_each_cell(blocks.blocks[b], [&](std::uint32_t voxel, unsigned cell) {
        std::uint32_t* out = grid.neighbours.data() + grid.neighbour_offsets[voxel];
        for_each_row(blocks, around[b], cell,
                     [&](const VoxelBlock& block, unsigned word, std::uint64_t bits) {
                       std::uint32_t id =
                           block.rank(word << 6 | static_cast<unsigned>(std::countr_zero(bits)));
                       for (int n = std::popcount(bits); n > 0; --n, ++id) {
                         if (id != voxel) *out++ = id;  // a row's voxels follow in number too
                       }
                     });
      });
    }
  });
}

}  // namespace

VoxelGrid make_voxel_grid(const PointCloud& cloud, double voxel_size, bool with_color) {
  const Addressing address = make_addressing(cloud, voxel_size);
  const Blocks blocks = number_voxels(find_occupied(cloud, address));
  VoxelGrid grid;
  grid.size = static_cast<float>(voxel_size);
  grid.lower = address.bounds.lower;
  grid.stray_points = address.bounds.strays;
  locate_points(cloud, address, blocks, grid);
  average_points(cloud, grid, blocks.voxel_count, with_color && cloud.has_colors());
  link_voxels(blocks, grid);
  return grid;
}

}  // namespace planescope
