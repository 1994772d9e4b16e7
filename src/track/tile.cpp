// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track/tile.hpp"

#include <algorithm>
#include <cmath>

namespace planescope::track {
namespace {

VoxelKey voxel_of(const Eigen::Vector3f& p, double voxel_size) {
  const auto part = [&](float v) {
    return static_cast<std::int32_t>(std::floor(static_cast<double>(v) / voxel_size));
  };
  return {part(p.z()), part(p.y()), part(p.x())};
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

PointCloud gather(const std::map<BlockKey, PointCloud>& pieces) {
  PointCloud cloud;
  for (const auto& [key, piece] : pieces) {
    append(cloud.positions, piece.positions);
    append(cloud.normals, piece.normals);
    append(cloud.colors, piece.colors);
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

/// Entries (voxel, value) into one a voxel: the value that most have, of equals the lowest.
std::vector<std::pair<VoxelKey, std::uint32_t>> majority(
    std::vector<std::pair<VoxelKey, std::uint32_t>> entries) {
  std::sort(entries.begin(), entries.end());
  std::vector<std::pair<VoxelKey, std::uint32_t>> result;
  std::size_t best = 0;
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end] == entries[begin]) ++end;
    const bool same = !result.empty() && result.back().first == entries[begin].first;
    if (same && end - begin <= best) continue;
    if (same) result.pop_back();
    result.push_back(entries[begin]);
    best = end - begin;
  }
  return result;
}

std::uint32_t find(const std::vector<std::pair<VoxelKey, std::uint32_t>>& sorted,
                   const VoxelKey& key, std::uint32_t missing) {
  const auto found = std::lower_bound(sorted.begin(), sorted.end(), std::pair(key, 0u));
  return found != sorted.end() && found->first == key ? found->second : missing;
}

}  // namespace

void patch_tile(Tile& tile, const BlockKey& key, double tile_size, const PatchOptions& options) {
  tile.cloud = gather(tile.pieces);
  tile.graph = {};
  tile.rim.clear();
  const bool any = std::ranges::any_of(tile.cloud.positions, is_finite);
  if (!any) {
    tile.graph.point_patch.assign(tile.cloud.size(), kNone);
    return;
  }
  tile.graph = make_patches(tile.cloud, options);
  const Eigen::Vector3f lower = (Eigen::Vector3d(key.x, key.y, key.z) * tile_size).cast<float>();
  // Cells of fused pieces reach a voxel over their block's face.
  const auto margin = static_cast<float>(2 * options.voxel_size);
  const auto side = static_cast<float>(tile_size);
  std::vector<std::pair<VoxelKey, std::uint32_t>> entries;
  for (std::size_t i = 0; i < tile.cloud.size(); ++i) {
    if (tile.graph.point_patch[i] == kNone) continue;
    const Eigen::Array3f local = (tile.cloud.positions[i] - lower).array();
    if ((local > margin).all() && (local < side - margin).all()) continue;
    entries.emplace_back(voxel_of(tile.cloud.positions[i], options.voxel_size),
                         static_cast<std::uint32_t>(tile.graph.point_patch[i]));
  }
  tile.rim = majority(std::move(entries));
  if (tile.rim.empty()) return;
  tile.rim_lower = tile.rim_upper = tile.rim.front().first;
  for (const auto& [voxel, patch] : tile.rim) {
    for (std::size_t k = 0; k < 3; ++k) {
      tile.rim_lower[k] = std::min(tile.rim_lower[k], voxel[k]);
      tile.rim_upper[k] = std::max(tile.rim_upper[k], voxel[k]);
    }
  }
}

std::vector<Adjacency> join_tiles(const Tile& a, const Tile& b) {
  constexpr std::uint32_t kMissing = ~0u;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (a.rim.empty() || b.rim.empty()) return {};
  for (const auto& [voxel, patch] : a.rim) {
    bool near_other = true;
    for (std::size_t k = 0; k < 3; ++k) {
      near_other = near_other && voxel[k] >= b.rim_lower[k] - 1 && voxel[k] <= b.rim_upper[k] + 1;
    }
    if (!near_other) continue;
    for (int n = 0; n < 27; ++n) {
      const VoxelKey near = {voxel[0] + n / 9 - 1, voxel[1] + n / 3 % 3 - 1, voxel[2] + n % 3 - 1};
      const std::uint32_t other = find(b.rim, near, kMissing);
      if (other != kMissing) pairs.emplace_back(patch, other);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<Adjacency> joined;
  for (const auto& [first, second] : pairs) {
    if (joined.empty() || joined.back().first != first || joined.back().second != second) {
      joined.push_back({first, second, 0});
    }
    ++joined.back().border;
  }
  return joined;
}

PlaceMemory remember(const Tile& tile, const std::vector<std::uint32_t>& patch_object,
                     double voxel_size) {
  PlaceMemory entries;
  for (std::size_t i = 0; i < tile.cloud.size(); ++i) {
    const std::int32_t patch = tile.graph.point_patch[i];
    if (patch == kNone) continue;
    entries.emplace_back(voxel_of(tile.cloud.positions[i], voxel_size),
                         patch_object[static_cast<std::size_t>(patch)]);
  }
  return majority(std::move(entries));
}

void vote(Tile& tile, const PlaceMemory& memory, double voxel_size) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> counts(tile.graph.patches.size());
  for (std::size_t i = 0; i < tile.cloud.size(); ++i) {
    const std::int32_t patch = tile.graph.point_patch[i];
    if (patch == kNone) continue;
    const std::uint32_t object = find(memory, voxel_of(tile.cloud.positions[i], voxel_size), 0);
    if (object != 0) ++counts[static_cast<std::size_t>(patch)][object];
  }
  tile.votes.clear();
  for (const auto& count : counts) tile.votes.emplace_back(count.begin(), count.end());
}

}  // namespace planescope::track
