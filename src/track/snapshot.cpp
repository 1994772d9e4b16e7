// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include "planescope/error.hpp"
#include "track/snapshot_parts.hpp"
#include "track/tracker_state.hpp"

/// \file A tracker as bytes: one section `tracker` (io/state_stream.hpp) of parts whose layout
/// track/snapshot_parts.hpp gives:
/// - the options
/// - u64 each: updates; patches, planes and segments of the last segmentation
/// - origin: u8 whether known, 3 f64
/// - objects: the last number, u32; lists of u32: those alive, those that had a plane
/// - planes held: supporting ones, faces; where a segmentation is under way, as it found them
/// - u64 count of tiles, each:
///   - its key; u64 count of pieces, each: key, u8 times, cloud
///   - u64 points changed; u8 flags: 1 dirty, 2 patched, 4 fresh
///   - patched and dirty: the cloud that was patched, u64 count of its pieces, each: key, u32
///   points
///   - patched, not fresh: list of u32, the object of each patch
///   - fresh: memory, votes
/// Patches, rims, joints and the stages of a segmentation under way follow from these, and are made
/// again: nothing that is read can contradict them. What the last segmentation looked like is not
/// kept.
namespace planescope {

using track::PatchedTile;
using track::Piece;
using track::Tile;
using track::TilePoints;

namespace {

constexpr std::uint32_t kVersion = 2;
constexpr const char* kName = "tracker";
enum Flag : std::uint8_t { kDirty = 1, kPatched = 2, kFresh = 4 };

void put_tile(io::StateWriter& to, const Tile& tile) {
  to.put<std::uint64_t>(tile.pieces.size());
  for (const auto& [key, piece] : tile.pieces) {
    track::put_key(to, key);
    to.put(piece.times);
    track::put_cloud(to, piece.points);
  }
  to.put<std::uint64_t>(tile.changed);
  const int flags =
      (tile.dirty ? kDirty : 0) | (tile.patched ? kPatched : 0) | (tile.fresh ? kFresh : 0);
  to.put(static_cast<std::uint8_t>(flags));
  if (tile.patched && tile.dirty) {
    track::put_cloud(to, tile.patched->cloud);
    to.put<std::uint64_t>(tile.patched->pieces.size());
    for (const auto& [key, count] : tile.patched->pieces) {
      track::put_key(to, key);
      to.put(count);
    }
  }
  if (tile.patched && !tile.fresh) to.list(tile.objects);
  if (!tile.fresh) return;
  track::put_memory(to, tile.memory);
  track::put_votes(to, tile.votes);
}

}  // namespace

void MapTracker::write(std::ostream& stream) const {
  const State& state = *state_;
  io::StateWriter to(stream, kName, kVersion);
  track::put_options(to, state.options);
  to.put(state.updates);
  for (const std::uint64_t n : {state.patch_count, state.plane_count, state.segment_count}) {
    to.put(n);
  }
  to.put<std::uint8_t>(state.origin ? 1 : 0);
  for (int k = 0; k < 3; ++k) to.put(state.origin ? (*state.origin)[k] : 0.0);
  state.book.write(to);
  const HeldPlanes& held = state.job ? state.job->held_before : state.held;
  track::put_planes(to, held.supporting);
  track::put_planes(to, held.faces);
  to.put<std::uint64_t>(state.tiles.size());
  for (const auto& [key, tile] : state.tiles) {
    track::put_key(to, key);
    put_tile(to, tile);
  }
  to.finish();
}

namespace {

/// A tile, and what is to be patched of it once the section is known to be whole.
struct Stored {
  BlockKey key;
  Tile tile;
  std::uint8_t flags = 0;
  TilePoints points;  ///< as they were patched
};

void get_pieces(io::StateReader& from, const Eigen::Vector3d& origin, Stored& stored) {
  const std::size_t count = from.length(12);
  for (std::size_t i = 0; i < count; ++i) {
    const BlockKey key = track::get_key(from);
    Piece piece;
    piece.times = from.get<std::uint8_t>();
    piece.points = track::get_cloud(from, origin);
    piece.mean = track::mean_of(piece.points);
    from.require(piece.points.size() > 0, "a piece without points");
    stored.tile.points += piece.points.size();
    from.require(stored.tile.pieces.emplace(key, std::move(piece)).second, "a piece twice");
  }
}

/// The points that were patched: those of the pieces, or as they were stored.
void get_patched(io::StateReader& from, const Eigen::Vector3d& origin, Stored& stored) {
  if ((stored.flags & kDirty) == 0) {
    stored.points = track::gather(stored.tile.pieces);
    return;
  }
  stored.points.cloud = track::get_cloud(from, origin);
  const std::size_t count = from.length(16);
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const BlockKey key = track::get_key(from);
    const auto size = from.get<std::uint32_t>();
    points += size;
    stored.points.pieces.emplace_back(key, size);
  }
  from.require(points == stored.points.cloud.size(),
               "a tile whose pieces have other points than it");
}

Stored get_tile(io::StateReader& from, const Eigen::Vector3d& origin, std::uint32_t last_object) {
  Stored stored;
  stored.key = track::get_key(from);
  get_pieces(from, origin, stored);
  stored.tile.changed = from.get<std::uint64_t>();
  stored.flags = from.get<std::uint8_t>();
  const bool patched = (stored.flags & kPatched) != 0;
  stored.tile.dirty = (stored.flags & kDirty) != 0;
  stored.tile.fresh = (stored.flags & kFresh) != 0;
  from.require(stored.flags <= 7 && (patched || (!stored.tile.fresh && stored.tile.dirty)),
               "a tile of no known state");
  if (patched) get_patched(from, origin, stored);
  if (patched && !stored.tile.fresh) {
    stored.tile.objects = from.list<std::uint32_t>();
    for (const std::uint32_t object : stored.tile.objects) {
      from.require(object >= 1 && object <= last_object, "a patch of no object");
    }
  }
  if (stored.tile.fresh) {
    stored.tile.memory = track::get_memory(from, last_object);
    stored.tile.votes = track::get_votes(from, last_object);
  }
  return stored;
}

/// Patches what was patched.
void patch_again(Stored& stored, const TrackOptions& options) {
  if ((stored.flags & kPatched) == 0) return;
  Tile& tile = stored.tile;
  tile.patched = std::make_shared<const PatchedTile>(track::patch_tile(
      std::move(stored.points), stored.key, options.tile_size, options.engine.patches));
}

}  // namespace

MapTracker MapTracker::read(std::istream& stream, const std::string& name) try {
  io::StateReader from(stream, name, kName, kVersion);
  MapTracker tracker(track::get_options(from));
  State& state = *tracker.state_;
  for (std::uint64_t* n :
       {&state.updates, &state.patch_count, &state.plane_count, &state.segment_count}) {
    *n = from.get<std::uint64_t>();
  }
  const bool placed = from.get<std::uint8_t>() != 0;
  Eigen::Vector3d origin;
  for (int k = 0; k < 3; ++k) origin[k] = from.get<double>();
  from.require(origin.allFinite(), "an origin that is no place");
  if (placed) state.origin = origin;
  state.book = track::ObjectBook::read(from);
  state.held.supporting = track::get_planes(from);
  state.held.faces = track::get_planes(from);
  std::vector<Stored> tiles;
  for (std::size_t left = from.length(12); left > 0; --left) {
    tiles.push_back(get_tile(from, origin, state.book.last()));
  }
  from.finish();
  tbb::parallel_for(std::size_t{0}, tiles.size(),
                    [&](std::size_t i) { patch_again(tiles[i], state.options); });
  std::vector<BlockKey> keys;
  for (Stored& stored : tiles) {
    const Tile& tile = stored.tile;
    from.require((tile.fresh ? tile.votes.size() : tile.objects.size()) == tile.patch_count(),
                 "not one object a patch: another version of the engine made it");
    state.point_count += tile.points;
    if (tile.patched) keys.push_back(stored.key);
    const auto [entry, added] = state.tiles.emplace(stored.key, std::move(stored.tile));
    from.require(added, "a tile twice");
    for (auto& [key, piece] : entry->second.pieces) {
      from.require(state.home_of.emplace(key, State::Home{stored.key, &piece}).second,
                   "a piece in two tiles");
    }
  }
  state.join(keys);
  state.take_up_job();
  return tracker;
} catch (const Error& error) {
  if (error.kind() == Error::Kind::Input) throw;
  throw Error(Error::Kind::Input, name + ": is damaged: " + error.what());
}

}  // namespace planescope
