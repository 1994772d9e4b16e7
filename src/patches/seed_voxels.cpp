// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <numeric>

#include "patches/growth.hpp"
#include "patches/voxel_blocks.hpp"

namespace planescope {
namespace {

// A cell of the seed grid.
struct SeedCell {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::uint32_t count = 0;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  std::uint32_t voxel = kNoVoxel;
  float distance = std::numeric_limits<float>::infinity();
};

}  // namespace

std::vector<std::uint32_t> choose_seeds(const VoxelGrid& grid, double patch_size) {
  const auto inverse = static_cast<float>(1.0 / patch_size);
  const auto key_of = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f scaled = (p - grid.lower) * inverse;
    return static_cast<std::uint64_t>(scaled.z()) << 42 |
           static_cast<std::uint64_t>(scaled.y()) << 21 | static_cast<std::uint64_t>(scaled.x());
  };
  BlockMap map(grid.voxel_count() / 16 + 16);
  std::vector<SeedCell> cells;
  std::vector<std::uint32_t> cell_of(grid.voxel_count());
  std::uint64_t last_key = 0;
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    const std::uint64_t key = key_of(grid.mean[v]);  // mostly that of the voxel before
    cell_of[v] = v > 0 && key == last_key ? cell_of[v - 1] : map.insert(key);
    last_key = key;
    if (cell_of[v] == cells.size()) cells.emplace_back();
    cells[cell_of[v]].sum += grid.mean[v].cast<double>();
    ++cells[cell_of[v]].count;
  }
  for (SeedCell& cell : cells) cell.mean = (cell.sum / cell.count).cast<float>();
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    SeedCell& cell = cells[cell_of[v]];
    const float d = (grid.mean[v] - cell.mean).squaredNorm();
    if (d < cell.distance) {
      cell.distance = d;
      cell.voxel = static_cast<std::uint32_t>(v);
    }
  }
  const double radius = 0.5 * patch_size / grid.size;  // [voxels]
  const double enough = 0.05 * radius * radius * 3.14159265358979;
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return map.keys()[a] < map.keys()[b]; });
  std::vector<std::uint32_t> seeds;
  for (const std::uint32_t c : order) {
    if (cells[c].count >= enough) seeds.push_back(cells[c].voxel);
  }
  return seeds;
}

}  // namespace planescope
