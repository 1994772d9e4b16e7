// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>

#include "track/tracker_state.hpp"

namespace planescope {

using track::Tile;

namespace {

/// A tile with what stands in place of its pieces.
struct Latest {
  const Tile* tile = nullptr;  ///< null: none was here
  bool other = false;          ///< a piece differs from the tile's
  std::map<BlockKey, const PointCloud*> pieces;
};

/// The objects that a tile's points had, whether or not they have changed since it was patched.
class TileObjects {
 public:
  TileObjects(const Latest& latest, double place_size)
      : tile_(latest.tile), place_size_(place_size) {
    if (tile_ == nullptr || !tile_->patched) return;
    same_points_ = !tile_->dirty && !tile_->fresh && !latest.other;
    if (!same_points_ && !tile_->fresh) {
      own_ = track::remember(*tile_->patched, tile_->objects, place_size);
    }
  }

  /// Of the i-th point, at `p`; 0: none.
  std::uint32_t find(std::size_t i, const Eigen::Vector3f& p) const {
    if (tile_ == nullptr || !tile_->patched) return 0;
    if (!same_points_) return track::recall(own_ ? *own_ : tile_->memory, p, place_size_);
    const std::int32_t patch = tile_->patched->graph.point_patch[i];
    return patch == kNone ? 0 : tile_->objects[static_cast<std::size_t>(patch)];
  }

 private:
  const Tile* tile_;
  double place_size_;
  bool same_points_ = false;
  std::optional<track::PlaceMemory> own_;
};

/// The map, and what was known of its points.
struct LatestMap {
  PointCloud cloud;
  std::vector<std::uint32_t> before;  ///< per point: its object, or 0
  std::vector<std::uint8_t> steady;   ///< per point: 1 if its piece was given often
};

LatestMap gather(const std::map<BlockKey, Latest>& tiles, const TrackOptions& options,
                 double place_size) {
  LatestMap map;
  for (const auto& [key, latest] : tiles) {
    const TileObjects known(latest, place_size);
    std::size_t i = 0;
    for (const auto& [name, points] : latest.pieces) {
      track::append(*points, map.cloud);
      const bool placed = latest.tile != nullptr && latest.tile->pieces.contains(name);
      const unsigned times = placed ? latest.tile->pieces.at(name).times : 0;
      map.steady.resize(map.cloud.size(), times >= options.steady_after ? 1 : 0);
      for (const Eigen::Vector3f& p : points->positions) map.before.push_back(known.find(i++, p));
    }
  }
  map.cloud.width = static_cast<std::uint32_t>(map.cloud.size());
  return map;
}

std::vector<track::Overlap> count_overlaps(const LatestMap& map,
                                           const std::vector<std::uint32_t>& label) {
  track::OverlapSums sums;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (map.before[i] != 0 && label[i] != kNoSegment)
      sums.add({label[i] - 1, map.before[i], 1, map.steady[i]});
  }
  return sums.list();
}

}  // namespace

TrackResult MapTracker::State::finish(std::uint32_t frame,
                                      std::span<const SurfacePiece> pieces) const {
  std::map<BlockKey, Latest> latest;
  for (const auto& [key, tile] : tiles) {
    Latest& own = latest[key];
    own.tile = &tile;
    for (const auto& [name, piece] : tile.pieces) own.pieces[name] = &piece.points;
  }
  for (const SurfacePiece& piece : pieces) {
    const Eigen::Vector3d mean = checked_mean(piece);
    const auto known = home_of.find(piece.key);
    if (known != home_of.end()) {
      Latest& own = latest.at(known->second.tile);
      own.other = own.other || piece.points.positions != own.pieces.at(piece.key)->positions;
      own.pieces.erase(piece.key);
    }
    if (piece.points.positions.empty()) continue;
    Latest& own = latest[place(mean, known == home_of.end() ? nullptr : &known->second.tile)];
    own.other = own.other || own.tile == nullptr || !own.tile->pieces.contains(piece.key);
    own.pieces[piece.key] = &piece.points;
  }
  LatestMap whole = gather(latest, options, place_size());
  const auto first = std::ranges::find_if(
      pieces, [](const SurfacePiece& piece) { return !piece.points.positions.empty(); });
  const Eigen::Vector3d nowhere =
      first == pieces.end() ? Eigen::Vector3d(0, 0, 0) : first->points.origin;
  whole.cloud.origin = origin.value_or(nowhere);
  TrackResult result;
  result.scene = segment(whole.cloud, options.engine);
  result.step.frame = frame;
  result.step.segmented = true;
  track::ObjectBook own = book;
  result.objects = own.match(result.scene.segments.segments,
                             count_overlaps(whole, result.scene.point_label), result.step);
  result.map = std::move(whole.cloud);
  result.step.points = result.map.size();
  result.step.patches = result.scene.graph.patches.size();
  result.step.planes = result.scene.planes.size();
  result.step.segments = result.scene.segments.segments.size();
  return result;
}

}  // namespace planescope
