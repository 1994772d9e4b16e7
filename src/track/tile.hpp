// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "planescope/patches.hpp"
#include "planescope/track.hpp"

namespace planescope::track {

/// A voxel of the lattice that all tiles share, ascending by (z, y, x).
using VoxelKey = std::array<std::int32_t, 3>;

struct VoxelHash {
  std::size_t operator()(const VoxelKey& key) const noexcept {
    std::uint64_t h = 0;
    for (const std::int32_t part : key) {
      h = (h ^ static_cast<std::uint32_t>(part)) * 0x9E3779B97F4A7C15ull;
      h ^= h >> 29;
    }
    return h;
  }
};

/// Adds the points at the end of a cloud; its width is left alone. Where only one of the two has
/// colours the other's points are grey.
void append(const PointCloud& points, PointCloud& to);

/// [m] Of the finite points; zero where there are none.
Eigen::Vector3d mean_of(const PointCloud& cloud);

/// A piece as the map has it.
struct Piece {
  PointCloud points;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  ///< [m] of the points
  std::uint8_t times = 0;                          ///< it was given, at most 255
};

/// The points of pieces, one after the other.
struct TilePoints {
  PointCloud cloud;
  std::vector<std::pair<BlockKey, std::uint32_t>> pieces;  ///< with their number of points
};

/// By the pieces' keys.
TilePoints gather(const std::map<BlockKey, Piece>& pieces);

/// A tile's surface as it was patched.
struct PatchedTile : TilePoints {
  PatchGraph graph;  ///< of the cloud
  /// Voxels at the tile's faces, with the patch that most of their points are in; sorted.
  std::vector<std::pair<VoxelKey, std::uint32_t>> rim;
  VoxelKey rim_lower{}, rim_upper{};  ///< of the rim's voxels along each axis
};

/// Patches points. \param tile_size,key place of the tile.
PatchedTile patch_tile(TilePoints points, const BlockKey& key, double tile_size,
                       const PatchOptions& options);

/// Points of one patch that were of one object before.
struct Vote {
  std::uint32_t object = 0, points = 0;
  std::uint32_t steady = 0;  ///< of the points: in pieces that were given often
};

/// The objects of a tile's places, to vote for what comes after: voxels with the object that
/// prevails among their points.
struct Place {
  std::uint32_t object = 0;
  std::int32_t lead = 0;  ///< while it is found: of the object over all others
};
using PlaceMemory = std::unordered_map<VoxelKey, Place, VoxelHash>;

/// A cube of the map that is patched by itself.
struct Tile {
  std::map<BlockKey, Piece> pieces;
  std::size_t points = 0;   ///< of the pieces
  std::size_t changed = 0;  ///< points that were put or taken since it was patched
  bool dirty = false;       ///< pieces changed since it was patched

  std::shared_ptr<const PatchedTile> patched;  ///< null: never
  bool fresh = false;                          ///< patched since the last segmentation
  std::vector<std::uint32_t> objects;    ///< per patch, of the last segmentation; unless fresh
  PlaceMemory memory;                    ///< objects before it was patched; only if fresh
  std::vector<std::vector<Vote>> votes;  ///< per patch, ascending by object; if fresh
  std::vector<std::uint32_t> steady;     ///< steady_points(), unless they have to be counted anew

  std::size_t patch_count() const { return patched ? patched->graph.patches.size() : 0; }
};

/// Pairs of patches of two tiles that touch, with their border: first of `a`, second of `b`.
std::vector<Adjacency> join_tiles(const PatchedTile& a, const PatchedTile& b);

/// Where the patches' objects are. \param place_size [m] edge of a place.
PlaceMemory remember(const PatchedTile& tile, const std::vector<std::uint32_t>& patch_object,
                     double place_size);

/// The object of a place; 0: none.
std::uint32_t recall(const PlaceMemory& memory, const Eigen::Vector3f& point, double place_size);

/// Per patch: how many points each object had where they are. \param steady_after see TrackOptions.
std::vector<std::vector<Vote>> vote(const Tile& tile, double place_size, unsigned steady_after);

/// Per patch: its points that lie in pieces which were given often.
std::vector<std::uint32_t> steady_points(const Tile& tile, unsigned steady_after);

}  // namespace planescope::track
