// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "planescope/patches.hpp"
#include "planescope/track.hpp"

namespace planescope::track {

/// A voxel of the lattice that all tiles share, ascending by (z, y, x).
using VoxelKey = std::array<std::int32_t, 3>;

/// A cube of the map that is patched by itself.
struct Tile {
  std::map<BlockKey, PointCloud> pieces;
  bool dirty = false;

  PointCloud cloud;  ///< of its pieces, in the order of their keys
  PatchGraph graph;  ///< of the cloud
  /// Per patch: how many of its points were of which object before, ascending by object.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> votes;
  /// Voxels at the tile's faces, with the patch that most of their points are in; sorted.
  std::vector<std::pair<VoxelKey, std::uint32_t>> rim;
  VoxelKey rim_lower{}, rim_upper{};  ///< of the rim's voxels along each axis
};

/// Makes cloud, graph and rim anew from the pieces. \param tile_size,key place of the tile.
void patch_tile(Tile& tile, const BlockKey& key, double tile_size, const PatchOptions& options);

/// Pairs of patches of two tiles that touch, with their border: first of `a`, second of `b`.
std::vector<Adjacency> join_tiles(const Tile& a, const Tile& b);

/// The objects of a tile's places, to vote for what comes after: voxels with the object of most of
/// their points, sorted.
using PlaceMemory = std::vector<std::pair<VoxelKey, std::uint32_t>>;
PlaceMemory remember(const Tile& tile, const std::vector<std::uint32_t>& patch_object,
                     double voxel_size);

/// Fills tile.votes: each point asks the memory of its voxel.
void vote(Tile& tile, const PlaceMemory& memory, double voxel_size);

}  // namespace planescope::track
