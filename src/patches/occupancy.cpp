// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/occupancy.hpp"

#include <algorithm>
#include <bit>
#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "patches/voxel_grid.hpp"
#include "simd.hpp"

namespace planescope {
namespace {

constexpr std::size_t kChunk = 16384;  // points a task
constexpr unsigned kCellBits = 9;      // a block has 512 cells
constexpr unsigned kCellMask = (1u << kCellBits) - 1;
static_assert(kMostBlocks + kChunk < (std::size_t{1} << (32 - kCellBits)) - 1);

// Blocks that one thread met, in the order in which it met them, and where they are among all.
struct Part {
  BlockMap map;
  std::vector<std::array<std::uint64_t, 8>> bits;
  std::vector<std::uint32_t> number;

  std::uint32_t index(std::uint64_t key) {
    const std::uint32_t at = map.insert(key);
    if (at == bits.size()) bits.push_back({});
    return at;
  }
};

// The parts of one thread: one that might outgrow its limit is left for a new one.
struct Parts {
  std::vector<std::unique_ptr<Part>> parts;

  Part& current(std::size_t most_blocks) {
    if (parts.empty() || parts.back()->bits.size() > most_blocks)
      parts.push_back(std::make_unique<Part>());
    return *parts.back();
  }
};

// First pass: point_voxel becomes (block of the part) * 512 + cell, and the cell is marked.
void mark(const PointCloud& cloud, const GridBounds& bounds, float inverse, std::size_t begin,
          std::size_t end, Part& part, std::uint32_t* point_voxel) {
  const Float4 corner = Float4::load3(bounds.lower.data()), scale(inverse);
  std::int64_t last_key = -1;
  std::uint32_t block = 0;
  std::uint64_t* bits = nullptr;  // scans stay in a block for several points
  for (std::size_t i = begin; i != end; ++i) {
    const Float4 p = Float4::load3(cloud.positions[i].data());
    if (!is_finite3(p) || (bounds.strays > 0 && !bounds.takes(cloud.positions[i]))) {
      point_voxel[i] = kNoVoxel;
      continue;
    }
    std::array<std::int32_t, 4> cell;
    truncate((p - corner) * scale, cell.data());  // never negative: truncation is floor
    const std::int32_t x = cell[0], y = cell[1], z = cell[2];
    const std::int64_t key = block_key(x >> 3, y >> 3, z >> 3);
    if (key != last_key) {
      block = part.index(static_cast<std::uint64_t>(key));
      bits = part.bits[block].data();
      last_key = key;
    }
    const auto word = static_cast<unsigned>(z & 7),
               bit = static_cast<unsigned>((y & 7) << 3 | (x & 7));
    bits[word] |= std::uint64_t{1} << bit;
    point_voxel[i] = block << kCellBits | word << 6 | bit;
  }
}

// Where a block of some part comes in the order of all.
struct Place {
  std::uint64_t key;
  Part* part;
  std::uint32_t index;  // in the part
};

std::vector<Place> sorted_places(const std::vector<Part*>& parts) {
  std::size_t count = 0;
  for (const Part* part : parts) count += part->bits.size();
  std::vector<Place> places;
  places.reserve(count);
  for (Part* part : parts) {
    for (std::uint32_t i = 0; i < part->bits.size(); ++i)
      places.push_back({part->map.keys()[i], part, i});
    part->number.resize(part->bits.size());
  }
  // Blocks that several parts met come in any order, which does not matter.
  tbb::parallel_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.key < b.key; });
  return places;
}

// The union of the parts' blocks, numbered by key.
VoxelBlocks unite(const std::vector<Part*>& parts) {
  VoxelBlocks all;
  for (const Place& place : sorted_places(parts)) {
    const auto key = static_cast<std::int64_t>(place.key);
    if (all.keys.empty() || all.keys.back() != key) {
      all.keys.push_back(key);
      all.blocks.emplace_back();
    }
    const auto& bits = place.part->bits[place.index];
    for (std::size_t w = 0; w < 8; ++w) all.blocks.back().bits[w] |= bits[w];
    place.part->number[place.index] = static_cast<std::uint32_t>(all.blocks.size() - 1);
  }
  for (VoxelBlock& block : all.blocks) {
    block.base = all.voxel_count;
    std::uint16_t before = 0;
    for (std::size_t w = 0; w < 8; ++w) {
      block.before[w] = before;
      before = static_cast<std::uint16_t>(before + std::popcount(block.bits[w]));
    }
    all.voxel_count += before;
  }
  return all;
}

// Second pass: from the part's block and cell to the voxel's number.
void number_points(const Part& part, const VoxelBlocks& all, std::uint32_t* begin,
                   std::uint32_t* end) {
  std::uint32_t last = kNoVoxel;
  const VoxelBlock* block = nullptr;
  for (std::uint32_t* at = begin; at != end; ++at) {
    if (*at == kNoVoxel) continue;
    if (*at >> kCellBits != last) {
      last = *at >> kCellBits;
      block = &all.blocks[part.number[last]];
    }
    *at = block->rank(*at & kCellMask);
  }
}

}  // namespace

VoxelBlocks find_occupied(const PointCloud& cloud, const GridBounds& bounds, float inverse,
                          std::vector<std::uint32_t>& point_voxel, std::size_t most_blocks) {
  point_voxel.resize(cloud.size());
  std::vector<Part*> chunk_part((cloud.size() + kChunk - 1) / kChunk);
  tbb::enumerable_thread_specific<Parts> local;
  tbb::parallel_for(std::size_t{0}, chunk_part.size(), [&](std::size_t chunk) {
    chunk_part[chunk] = &local.local().current(most_blocks);
    mark(cloud, bounds, inverse, chunk * kChunk, std::min(cloud.size(), (chunk + 1) * kChunk),
         *chunk_part[chunk], point_voxel.data());
  });
  std::vector<Part*> parts;
  for (const Parts& mine : local) {
    for (const auto& part : mine.parts) parts.push_back(part.get());
  }
  VoxelBlocks all = unite(parts);
  tbb::parallel_for(std::size_t{0}, chunk_part.size(), [&](std::size_t chunk) {
    number_points(*chunk_part[chunk], all, point_voxel.data() + chunk * kChunk,
                  point_voxel.data() + std::min(cloud.size(), (chunk + 1) * kChunk));
  });
  return all;
}

}  // namespace planescope
