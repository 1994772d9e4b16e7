// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "planescope/error.hpp"
#include "track/tracker_state.hpp"

namespace planescope {

using track::Tile;

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

Eigen::Vector3d mean_of(const PointCloud& cloud) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : cloud.positions) sum += p.cast<double>();
  return sum / static_cast<double>(std::max<std::size_t>(1, cloud.size()));
}

}  // namespace

std::string_view name(TrackEventKind kind) {
  constexpr std::array<std::string_view, 5> kNames = {"new", "split", "merge", "vanished", "plane"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool MapTracker::State::differs(const PointCloud& old, const PointCloud& now) const {
  const auto before = static_cast<double>(old.size()), after = static_cast<double>(now.size());
  if (std::abs(after - before) > options.change * std::max(before, after)) return true;
  const double moved = (mean_of(now) - mean_of(old)).norm();
  return moved > options.change * options.engine.patches.voxel_size;
}

BlockKey MapTracker::State::place(const PointCloud& piece) const {
  const Eigen::Vector3d tile = mean_of(piece) / options.tile_size;
  const auto part = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
  return {part(tile.x()), part(tile.y()), part(tile.z())};
}

/// Puts a piece into its tile. \returns whether that changed the map.
bool MapTracker::State::put(const SurfacePiece& piece, bool exactly) {
  if (!piece.points.positions.empty()) {
    if (piece.points.normals.size() != piece.points.size()) {
      throw Error(Error::Kind::Input, "tracking: a piece of the map has no normals");
    }
    if (!origin) origin = piece.points.origin;
    if (piece.points.origin != *origin) {
      throw Error(Error::Kind::Input, "tracking: a piece has another origin than the first one");
    }
  }
  const auto known = tile_of.find(piece.key);
  if (known != tile_of.end()) {
    Tile& tile = tiles.at(known->second);
    PointCloud& old = tile.pieces.at(piece.key);
    const bool same = old.positions == piece.points.positions;
    if (same || (!exactly && !differs(old, piece.points))) return false;
    tile.dirty = true;
    tile.pieces.erase(piece.key);
    tile_of.erase(known);
  } else if (piece.points.positions.empty()) {
    return false;
  }
  if (piece.points.positions.empty()) return true;
  const BlockKey key = place(piece.points);
  Tile& tile = tiles[key];
  tile.dirty = true;
  tile.pieces[piece.key] = piece.points;
  tile_of[piece.key] = key;
  return true;
}

/// Patches the dirty tiles anew; what their places were votes for what they become.
std::size_t MapTracker::State::repatch() {
  struct Work {
    BlockKey key;
    Tile* tile;
    std::vector<std::uint32_t> objects;  // of its patches before
  };
  std::vector<Work> dirty;
  std::size_t first = 0;
  for (auto& [key, tile] : tiles) {
    const std::size_t count = tile.graph.patches.size();
    const auto begin = patch_object.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<std::uint32_t> own(begin, begin + static_cast<std::ptrdiff_t>(count));
    first += count;
    if (tile.dirty) {
      dirty.push_back({key, &tile, own});
      continue;
    }
    tile.votes.clear();
    for (std::size_t p = 0; p < count; ++p) {
      tile.votes.push_back({{own[p], tile.graph.patches[p].point_count}});
    }
  }
  // Twice the patches' voxels: what moved by less than that is still the same place.
  const double place_size = 2 * options.engine.patches.voxel_size;
  tbb::parallel_for(std::size_t{0}, dirty.size(), [&](std::size_t d) {
    Tile& tile = *dirty[d].tile;
    const track::PlaceMemory memory = track::remember(tile, dirty[d].objects, place_size);
    track::patch_tile(tile, dirty[d].key, options.tile_size, options.engine.patches);
    track::vote(tile, memory, place_size);
  });
  std::vector<BlockKey> keys;
  for (const Work& work : dirty) {
    work.tile->dirty = false;
    keys.push_back(work.key);
  }
  join(keys);
  return dirty.size();
}

/// Finds anew which patches of the dirty tiles touch those of their neighbours.
void MapTracker::State::join(const std::vector<BlockKey>& dirty) {
  std::set<std::pair<BlockKey, BlockKey>> wanted;
  for (const BlockKey& key : dirty) {
    for (int n = 0; n < 27; ++n) {
      const BlockKey near{key.x + n % 3 - 1, key.y + n / 3 % 3 - 1, key.z + n / 9 - 1};
      if (near != key && tiles.contains(near)) {
        wanted.emplace(std::min(key, near), std::max(key, near));
      }
    }
  }
  const std::vector<std::pair<BlockKey, BlockKey>> pairs(wanted.begin(), wanted.end());
  std::vector<std::vector<Adjacency>> found(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    found[i] = track::join_tiles(tiles.at(pairs[i].first), tiles.at(pairs[i].second));
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) joints[pairs[i]] = std::move(found[i]);
}

TrackStep MapTracker::State::update(std::uint32_t frame, std::span<const SurfacePiece> pieces,
                                    bool exactly) {
  const auto start = std::chrono::steady_clock::now();
  TrackStep step;
  step.frame = frame;
  step.pieces = pieces.size();
  for (const SurfacePiece& piece : pieces) step.changed += put(piece, exactly) ? 1 : 0;
  if (step.changed > 0) {
    step.tiles = repatch();
    assemble();
    segment_map();
    objects = book.match(scene.segments.segments, overlaps(), step);
    patch_object.clear();
    for (const std::uint32_t label : scene.segments.patch_label) {
      patch_object.push_back(objects[label - 1]);
    }
  }
  step.points = point_count;
  step.patches = scene.graph.patches.size();
  step.planes = scene.planes.size();
  step.segments = scene.segments.segments.size();
  step.milliseconds = milliseconds_since(start);
  return step;
}

MapTracker::MapTracker(const TrackOptions& options) : state_(std::make_unique<State>()) {
  options.engine.validate();
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw Error(Error::Kind::Usage, "tracking: " + what);
  };
  require(options.tile_size >= 4 * options.engine.patches.patch_size && options.tile_size <= 100,
          "the tile size is " + std::to_string(options.tile_size) +
              " m; expected at least 4 patches.patch_size, at most 100");
  require(options.change > 0 && options.change <= 1,
          "the change is " + std::to_string(options.change) + "; expected more than 0, at most 1");
  require(options.engine.patches.range_exponent == 0,
          "patches.range_exponent is not 0: a map has no single sensor");
  state_->options = options;
  state_->scene.options = options.engine;
}

MapTracker::~MapTracker() = default;
MapTracker::MapTracker(MapTracker&&) noexcept = default;
MapTracker& MapTracker::operator=(MapTracker&&) noexcept = default;

TrackStep MapTracker::update(std::uint32_t frame, std::span<const SurfacePiece> pieces) {
  return state_->update(frame, pieces, false);
}

TrackStep MapTracker::update_exactly(std::uint32_t frame, std::span<const SurfacePiece> pieces) {
  return state_->update(frame, pieces, true);
}

TrackResult MapTracker::finish(std::uint32_t frame) const {
  const auto start = std::chrono::steady_clock::now();
  State& state = *state_;
  state.complete();
  TrackResult result;
  result.scene = segment(state.map, state.options.engine);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sums;
  for (std::size_t i = 0; i < state.map.size(); ++i) {
    const std::uint32_t before = state.scene.point_label[i], now = result.scene.point_label[i];
    if (before == kNoSegment || now == kNoSegment) continue;
    ++sums[{now - 1, state.objects[before - 1]}];
  }
  std::vector<track::Overlap> overlaps;
  for (const auto& [pair, points] : sums) overlaps.push_back({pair.first, pair.second, points});
  result.step.frame = frame;
  track::ObjectBook book = state.book;
  result.objects = book.match(result.scene.segments.segments, overlaps, result.step);
  result.step.points = state.map.size();
  result.step.patches = result.scene.graph.patches.size();
  result.step.planes = result.scene.planes.size();
  result.step.segments = result.scene.segments.segments.size();
  result.step.milliseconds = milliseconds_since(start);
  return result;
}

const PointCloud& MapTracker::map() const {
  state_->complete();
  return state_->map;
}

const Segmentation& MapTracker::scene() const {
  state_->complete();
  return state_->scene;
}

const std::vector<std::uint32_t>& MapTracker::objects() const noexcept { return state_->objects; }

}  // namespace planescope
