// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fusion/surface_nets.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace planescope::fusion {
namespace {

constexpr int kCorners = kSide + 1;
// Next to the surface distances are small: a jump from the truncation is the rim of something that
// only some frames saw.
constexpr float kNear = 0.98f;

struct Voxel {
  float distance = 0;
  bool known = false;
};

Voxel value_of(const Block& block, std::size_t voxel, std::uint32_t least) {
  return {block.distance[voxel], block.seen[voxel] >= least};
}

std::size_t index_of(int x, int y, int z) {
  return static_cast<std::size_t>((std::ptrdiff_t{z} * kSide + y) * kSide + x);
}

/// A block's voxels, and the next ones of its neighbours: the corners of all its cells.
class Corners {
 public:
  Corners(const BlockMap& blocks, const Block& block, std::uint32_t least) {
    for (int n = 0; n < 8; ++n) {
      const int dx = n & 1, dy = n >> 1 & 1, dz = n >> 2;
      const BlockKey key{block.key.x + dx, block.key.y + dy, block.key.z + dz};
      source_[static_cast<std::size_t>(n)] = n == 0 ? &block : blocks.find(key);
    }
    for (int z = 0; z < kCorners; ++z) {
      for (int y = 0; y < kCorners; ++y) {
        for (int x = 0; x < kCorners; ++x) {
          const Block* from = source(x, y, z);
          if (from != nullptr) at(x, y, z) = value_of(*from, voxel(x, y, z), least);
        }
      }
    }
  }

  Voxel& at(int x, int y, int z) {
    return voxels_[static_cast<std::size_t>((std::ptrdiff_t{z} * kCorners + y) * kCorners + x)];
  }
  const Block* source(int x, int y, int z) const {
    return source_[static_cast<std::size_t>((x / kSide) | (y / kSide) << 1 | (z / kSide) << 2)];
  }
  static std::size_t voxel(int x, int y, int z) {
    return index_of(x % kSide, y % kSide, z % kSide);
  }

 private:
  std::array<const Block*, 8> source_{};
  std::array<Voxel, std::size_t{kCorners} * kCorners * kCorners> voxels_{};
};

/// A cell with its eight corners, corner c at (c & 1, c >> 1 & 1, c >> 2).
struct Cell {
  int x, y, z;
  std::array<float, 8> distance;
};

/// The cell, if all its corners are known and not all on one side.
bool load_cell(Corners& corners, Cell& cell) {
  int inside = 0;
  for (int c = 0; c < 8; ++c) {
    const Voxel& v = corners.at(cell.x + (c & 1), cell.y + (c >> 1 & 1), cell.z + (c >> 2));
    if (!v.known) return false;
    cell.distance[static_cast<std::size_t>(c)] = v.distance;
    inside += v.distance < 0 ? 1 : 0;
  }
  return inside != 0 && inside != 8;
}

bool crosses(float a, float b) {
  return (a < 0) != (b < 0) && std::abs(a) < kNear && std::abs(b) < kNear;
}

/// Mean of where the surface crosses the cell's twelve edges, in [0, 1] along each axis; false
/// where no crossing can be trusted.
bool find_vertex(const Cell& cell, Eigen::Vector3f& vertex) {
  vertex.setZero();
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int c = 0; c < 8; ++c) {
      if ((c >> axis & 1) != 0) continue;
      const float a = cell.distance[static_cast<std::size_t>(c)];
      const float b = cell.distance[static_cast<std::size_t>(c | 1 << axis)];
      if (!crosses(a, b)) continue;
      Eigen::Vector3f point(static_cast<float>(c & 1), static_cast<float>(c >> 1 & 1),
                            static_cast<float>(c >> 2));
      point[axis] = a / (a - b);
      vertex += point;
      ++count;
    }
  }
  if (count > 0) vertex /= static_cast<float>(count);
  return count > 0;
}

/// Gradient of the field, linear between the corners, at a place of the cell.
Eigen::Vector3f gradient(const Cell& cell, const Eigen::Vector3f& at) {
  Eigen::Vector3f g = Eigen::Vector3f::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) != 0) continue;
      const float share = ((corner >> b & 1) != 0 ? at[b] : 1 - at[b]) *
                          ((corner >> c & 1) != 0 ? at[c] : 1 - at[c]);
      g[axis] += share * (cell.distance[static_cast<std::size_t>(corner | 1 << axis)] -
                          cell.distance[static_cast<std::size_t>(corner)]);
    }
  }
  const float length = g.norm();
  if (length > 0) return g / length;
  return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
}

/// Mean over the corners that have a colour, the nearer to the surface the more; grey where none
/// has.
Rgb color_of(const Corners& corners, const Cell& cell) {
  std::array<float, 3> sum{};
  float weight = 0;
  for (int c = 0; c < 8; ++c) {
    const int x = cell.x + (c & 1), y = cell.y + (c >> 1 & 1), z = cell.z + (c >> 2);
    const Block* block = corners.source(x, y, z);
    const std::size_t voxel = Corners::voxel(x, y, z);
    if (block->color_weight[voxel] == 0) continue;
    const float w = 1 / (0.02f + std::abs(cell.distance[static_cast<std::size_t>(c)]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += w * static_cast<float>(block->color[voxel][k]);
    weight += w;
  }
  if (weight == 0) return {128, 128, 128};
  const auto channel = [&](std::size_t k) {
    return static_cast<std::uint8_t>(std::min(255.0f, sum[k] / weight / 256 + 0.5f));
  };
  return {channel(0), channel(1), channel(2)};
}

}  // namespace

BlockSurface find_surface(const BlockMap& blocks, const Block& block, double voxel_size,
                          std::uint32_t least) {
  Corners corners(blocks, block, least);
  BlockSurface surface;
  const Eigen::Vector3d start = Eigen::Vector3d(block.key.x, block.key.y, block.key.z) * kSide;
  for (int index = 0; index < kVoxels; ++index) {
    Cell cell{index % kSide, index / kSide % kSide, index / (kSide * kSide), {}};
    Eigen::Vector3f vertex;
    if (!load_cell(corners, cell) || !find_vertex(cell, vertex)) continue;
    const Eigen::Vector3d place = start + Eigen::Vector3d(cell.x, cell.y, cell.z);
    surface.positions.push_back(((place + vertex.cast<double>()) * voxel_size).cast<float>());
    surface.normals.push_back(gradient(cell, vertex));
    surface.colors.push_back(color_of(corners, cell));
    surface.cells.push_back(static_cast<std::uint16_t>(index));
  }
  return surface;
}

int crossing(const BlockMap& blocks, const Block& block, int cell, int axis, std::uint32_t least) {
  std::array<int, 3> place = {cell % kSide, cell / kSide % kSide, cell / (kSide * kSide)};
  const Voxel here = value_of(block, static_cast<std::size_t>(cell), least);
  const Block* next = &block;
  if (++place[static_cast<std::size_t>(axis)] == kSide) {
    place[static_cast<std::size_t>(axis)] = 0;
    BlockKey key = block.key;
    (axis == 0 ? key.x : axis == 1 ? key.y : key.z) += 1;
    next = blocks.find(key);
    if (next == nullptr) return 0;
  }
  const Voxel there = value_of(*next, index_of(place[0], place[1], place[2]), least);
  if (!here.known || !there.known || !crosses(here.distance, there.distance)) return 0;
  return there.distance > here.distance ? 1 : -1;
}

}  // namespace planescope::fusion
