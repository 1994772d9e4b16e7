// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "planes/held_planes.hpp"
#include "track/objects.hpp"
#include "track/tile.hpp"

namespace planescope {

struct BlockHash {
  std::size_t operator()(const BlockKey& key) const noexcept {
    return track::VoxelHash{}({key.z, key.y, key.x});
  }
};

/// What a tracker holds; in the order in which an update runs through it.
struct MapTracker::State {
  TrackOptions options;
  std::map<BlockKey, track::Tile> tiles;
  /// Where a piece that has points is; nodes of maps stay in place.
  struct Home {
    BlockKey tile;
    track::Piece* piece = nullptr;
  };
  std::unordered_map<BlockKey, Home, BlockHash> home_of;
  /// Borders between patches of two tiles, each pair once, lower key first.
  std::map<std::pair<BlockKey, BlockKey>, std::vector<Adjacency>> joints;
  track::ObjectBook book;
  HeldPlanes held;
  std::uint64_t updates = 0;                                          ///< so far
  std::uint64_t patch_count = 0, plane_count = 0, segment_count = 0;  ///< of the last segmentation
  std::optional<Eigen::Vector3d> origin;
  std::size_t point_count = 0;  ///< of all pieces

  /// A segmentation that several updates share, a stage or more each. No tile is patched meanwhile.
  struct Job {
    std::vector<std::shared_ptr<const track::PatchedTile>> shown;  ///< the tiles as it sees them
    Segmentation scene;
    HeldPlanes held_before;  ///< the state's, when it began
  };
  std::optional<Job> job;

  /// The last segmentation, and the tiles as it saw them.
  std::vector<std::shared_ptr<const track::PatchedTile>> shown;
  PointCloud map;
  Segmentation scene;
  std::vector<std::uint32_t> objects;
  bool completed = true;  ///< map and the points' part of scene are there

  explicit State(const TrackOptions& chosen);

  /// [m] Twice the patches' voxels: what moved by less than that is still the same place.
  double place_size() const { return 2 * options.engine.patches.voxel_size; }

  // Pieces into tiles: map_tracker.cpp.
  Eigen::Vector3d checked_mean(const SurfacePiece& piece) const;
  bool put(const SurfacePiece& piece, const Eigen::Vector3d& mean, bool exactly);
  void remove(const BlockKey& key, track::Tile& tile);
  BlockKey place(const Eigen::Vector3d& mean, const BlockKey* before) const;
  TrackStep update(std::uint32_t frame, std::span<const SurfacePiece> pieces, bool exactly);
  void take_up_job();

  // Tiles into patches: repatch.cpp.
  std::vector<BlockKey> most_changed() const;
  std::size_t repatch();
  void join(const std::vector<BlockKey>& keys);

  // Patches into segments: assembly.cpp.
  void start_job();
  void run_stage(std::size_t stage, TrackStep& step);
  void book_segments(TrackStep& step);
  void book_objects();
  void complete();
  std::vector<track::Overlap> overlaps();

  TrackResult finish(std::uint32_t frame,
                     std::span<const SurfacePiece> pieces) const;  // finish.cpp
};

}  // namespace planescope
