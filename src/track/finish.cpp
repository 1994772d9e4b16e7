// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <optional>

#include "track/tracker_state.hpp"

namespace planescope {

using track::Tile;

namespace {

/// The objects that a tile's points had, whether or not they have changed since it was patched.
class TileObjects {
 public:
  TileObjects(const Tile& tile, double place_size) : tile_(tile), place_size_(place_size) {
    same_points_ = tile.patched && !tile.dirty && !tile.fresh;
    if (!same_points_ && !tile.fresh && tile.patched) {
      own_ = track::remember(*tile.patched, tile.objects, place_size);
    }
  }

  /// Of the i-th point, at `p`; 0: none.
  std::uint32_t find(std::size_t i, const Eigen::Vector3f& p) const {
    if (!same_points_) return track::recall(own_ ? *own_ : tile_.memory, p, place_size_);
    const std::int32_t patch = tile_.patched->graph.point_patch[i];
    return patch == kNone ? 0 : tile_.objects[static_cast<std::size_t>(patch)];
  }

 private:
  const Tile& tile_;
  double place_size_;
  bool same_points_ = false;
  std::optional<track::PlaceMemory> own_;
};

}  // namespace

TrackResult MapTracker::State::finish(std::uint32_t frame) const {
  TrackResult result;
  result.map.origin = origin.value_or(Eigen::Vector3d::Zero());
  std::vector<std::uint32_t> before;  // per point: its object
  std::vector<std::uint8_t> steady;   // per point
  for (const auto& [key, tile] : tiles) {
    const TileObjects known(tile, place_size());
    std::size_t i = 0;
    for (const auto& [name, piece] : tile.pieces) {
      track::append(piece.points, result.map);
      for (const Eigen::Vector3f& p : piece.points.positions) {
        before.push_back(known.find(i++, p));
        steady.push_back(piece.times >= options.steady_after ? 1 : 0);
      }
    }
  }
  result.map.width = static_cast<std::uint32_t>(result.map.size());
  result.scene = segment(result.map, options.engine);
  std::map<std::pair<std::uint32_t, std::uint32_t>, track::Overlap> sums;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::uint32_t now = result.scene.point_label[i];
    if (before[i] == 0 || now == kNoSegment) continue;
    track::Overlap& sum = sums[{now - 1, before[i]}];
    sum = {now - 1, before[i], sum.points + 1, sum.steady + steady[i]};
  }
  std::vector<track::Overlap> overlaps;
  for (const auto& [pair, sum] : sums) overlaps.push_back(sum);
  result.step.frame = frame;
  result.step.segmented = true;
  track::ObjectBook own = book;
  result.objects = own.match(result.scene.segments.segments, overlaps, result.step);
  result.step.points = result.map.size();
  result.step.patches = result.scene.graph.patches.size();
  result.step.planes = result.scene.planes.size();
  result.step.segments = result.scene.segments.segments.size();
  return result;
}

}  // namespace planescope
