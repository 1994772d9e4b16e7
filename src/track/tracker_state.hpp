// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "track/objects.hpp"
#include "track/tile.hpp"

namespace planescope {

/// What a tracker holds; in the order in which an update runs through it.
struct MapTracker::State {
  TrackOptions options;
  std::map<BlockKey, track::Tile> tiles;
  std::map<BlockKey, BlockKey> tile_of;  ///< per piece that has points
  /// Borders between patches of two tiles, each pair once, lower key first.
  std::map<std::pair<BlockKey, BlockKey>, std::vector<Adjacency>> joints;
  track::ObjectBook book;
  PointCloud map;
  Segmentation scene;
  std::vector<std::uint32_t> objects;
  std::vector<std::uint32_t> patch_object;  ///< of scene.graph
  std::optional<Eigen::Vector3d> origin;
  std::size_t point_count = 0;  ///< of the map
  bool completed = true;        ///< map and the points' part of scene are there

  bool differs(const PointCloud& old, const PointCloud& now) const;
  BlockKey place(const PointCloud& piece) const;
  bool put(const SurfacePiece& piece, bool exactly);
  std::size_t repatch();
  void join(const std::vector<BlockKey>& dirty);
  void assemble();
  void segment_map();
  void complete();
  std::vector<track::Overlap> overlaps() const;
  TrackStep update(std::uint32_t frame, std::span<const SurfacePiece> pieces, bool exactly);
};

}  // namespace planescope
