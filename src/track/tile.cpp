// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track/tile.hpp"

#include <algorithm>
#include <cmath>

namespace planescope::track {
namespace {

VoxelKey voxel_of(const Eigen::Vector3f& p, double voxel_size) {
  constexpr double kMost = 2e9;  // pieces may lie anywhere
  const double inverse = 1 / voxel_size;
  const auto part = [&](float v) {  // std::floor is a call without SSE 4.1, and this runs for all
    const double scaled = std::clamp(static_cast<double>(v) * inverse, -kMost, kMost);
    const auto whole = static_cast<std::int32_t>(scaled);
    return whole - (scaled < static_cast<double>(whole) ? 1 : 0);
  };
  return {part(p.z()), part(p.y()), part(p.x())};
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

/// Fills in which patches lie at the tile's faces, and where.
void find_rim(PatchedTile& tile, const BlockKey& key, double tile_size,
              const PatchOptions& options) {
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

/// Visits the points in patches: index, patch, whether the point's piece was given often.
template <class Visit>
void for_each_point(const Tile& tile, unsigned steady_after, const Visit& visit) {
  std::size_t i = 0;
  for (const auto& [key, count] : tile.patched->pieces) {
    const auto piece = tile.pieces.find(key);
    const bool steady = piece != tile.pieces.end() && piece->second.times >= steady_after;
    for (const std::size_t end = i + count; i < end; ++i) {
      const std::int32_t patch = tile.patched->graph.point_patch[i];
      if (patch != kNone) visit(i, static_cast<std::size_t>(patch), steady);
    }
  }
}

}  // namespace

void append(const PointCloud& points, PointCloud& to) {
  const auto add = [](auto& all, const auto& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  constexpr Rgb kUnseen{128, 128, 128};  // a camera's first frames may lack colours
  if (!points.colors.empty() || !to.colors.empty()) {
    to.colors.resize(to.size(), kUnseen);
    add(to.colors, points.colors);
    to.colors.resize(to.size() + points.size(), kUnseen);
  }
  add(to.positions, points.positions);
  add(to.normals, points.normals);
}

Eigen::Vector3d mean_of(const PointCloud& cloud) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : cloud.positions) sum += p.cast<double>();
  if (sum.allFinite()) return sum / static_cast<double>(std::max<std::size_t>(1, cloud.size()));
  sum.setZero();
  std::size_t count = 0;
  for (const Eigen::Vector3f& p : cloud.positions) {
    if (!is_finite(p)) continue;
    sum += p.cast<double>();
    ++count;
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, count));
}

TilePoints gather(const std::map<BlockKey, Piece>& pieces) {
  TilePoints all;
  std::size_t count = 0;
  for (const auto& [key, piece] : pieces) count += piece.points.size();
  all.cloud.positions.reserve(count);
  all.cloud.normals.reserve(count);
  for (const auto& [key, piece] : pieces) {
    append(piece.points, all.cloud);
    all.pieces.emplace_back(key, static_cast<std::uint32_t>(piece.points.size()));
  }
  return all;
}

PatchedTile patch_tile(TilePoints points, const BlockKey& key, double tile_size,
                       const PatchOptions& options) {
  PatchedTile tile{std::move(points), {}, {}, {}, {}};
  tile.cloud.width = static_cast<std::uint32_t>(tile.cloud.size());
  const bool any = std::ranges::any_of(tile.cloud.positions, is_finite);
  if (!any) {
    tile.graph.point_patch.assign(tile.cloud.size(), kNone);
    return tile;
  }
  tile.graph = make_patches(tile.cloud, options);
  find_rim(tile, key, tile_size, options);
  return tile;
}

std::vector<Adjacency> join_tiles(const PatchedTile& a, const PatchedTile& b) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  if (a.rim.empty() || b.rim.empty()) return {};
  for (const auto& [voxel, patch] : a.rim) {
    bool near_other = true;
    for (std::size_t k = 0; k < 3; ++k) {
      near_other = near_other && voxel[k] >= b.rim_lower[k] - 1 && voxel[k] <= b.rim_upper[k] + 1;
    }
    if (!near_other) continue;
    for (int n = 0; n < 9; ++n) {  // rows of three
      const VoxelKey left = {voxel[0] + n / 3 - 1, voxel[1] + n % 3 - 1, voxel[2] - 1};
      const VoxelKey right = {left[0], left[1], voxel[2] + 1};
      for (auto found = std::lower_bound(b.rim.begin(), b.rim.end(), std::pair(left, 0u));
           found != b.rim.end() && found->first <= right; ++found) {
        pairs.emplace_back(patch, found->second);
      }
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

PlaceMemory remember(const PatchedTile& tile, const std::vector<std::uint32_t>& patch_object,
                     double place_size) {
  PlaceMemory memory;
  for (std::size_t i = 0; i < tile.cloud.size(); ++i) {
    const std::int32_t patch = tile.graph.point_patch[i];
    if (patch == kNone) continue;
    const std::uint32_t object = patch_object[static_cast<std::size_t>(patch)];
    // Boyer and Moore's vote: whoever has more than half of the points wins it.
    Place& place = memory[voxel_of(tile.cloud.positions[i], place_size)];
    if (place.lead == 0) place.object = object;
    place.lead += place.object == object ? 1 : -1;
  }
  return memory;
}

std::uint32_t recall(const PlaceMemory& memory, const Eigen::Vector3f& point, double place_size) {
  if (memory.empty() || !is_finite(point)) return 0;
  const auto found = memory.find(voxel_of(point, place_size));
  return found == memory.end() ? 0 : found->second.object;
}

std::vector<std::vector<Vote>> vote(const Tile& tile, double place_size, unsigned steady_after) {
  std::vector<std::vector<Vote>> votes(tile.patch_count());
  const std::vector<Eigen::Vector3f>& positions = tile.patched->cloud.positions;
  for_each_point(tile, steady_after, [&](std::size_t i, std::size_t patch, bool steady) {
    const std::uint32_t object = recall(tile.memory, positions[i], place_size);
    if (object == 0) return;
    std::vector<Vote>& own = votes[patch];  // a few: sought one by one
    auto found = std::ranges::find(own, object, &Vote::object);
    if (found == own.end()) found = own.insert(own.end(), {object, 0, 0});
    ++found->points;
    if (steady) ++found->steady;
  });
  for (std::vector<Vote>& own : votes) std::ranges::sort(own, {}, &Vote::object);
  return votes;
}

std::vector<std::uint32_t> steady_points(const Tile& tile, unsigned steady_after) {
  std::vector<std::uint32_t> counts(tile.patch_count(), 0);
  for_each_point(tile, steady_after,
                 [&](std::size_t, std::size_t patch, bool steady) { counts[patch] += steady; });
  return counts;
}

}  // namespace planescope::track
