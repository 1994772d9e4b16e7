// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "io/state_stream.hpp"
#include "planescope/error.hpp"
#include "track/tracker_state.hpp"

/// \file A tracker as bytes: one section `tracker` (io/state_stream.hpp) of
///   options: text `name=value` lines of the engine, then tile_size, change, share (f64), interval,
///     least_points, steady_after (u32)
///   updates, patches, planes and segments of the last segmentation (u64); origin: u8 whether
///   known, 3 f64 objects: last number u32; lists of u32: alive, those that had a plane planes
///   held: two lists (u64 length) of planes, 4 f32 and u8 whether selected tiles: u64 count, each:
///   key 3 i32; pieces: u64 count, each: key 3 i32, times u8, cloud
///     changed u64; flags u8: 1 dirty, 2 patched, 4 fresh
///     patched and dirty: the cloud that was patched, u64 count of its pieces, each: key 3 i32, u32
///     patched, not fresh: list of u32, the object of each patch
///     fresh: u64 count of places, each: voxel (z, y, x) 3 i32, object u32; u64 count of patches,
///     each: u64 count of votes, each: object, points, steady (u32)
///   a cloud: lists of positions and normals (3 f32), and of colours (3 u8)
/// Patches, rims and joints follow from these, and are made again: nothing that is read can
/// contradict them. What the last segmentation looked like is not kept.
namespace planescope {

using track::PatchedTile;
using track::Piece;
using track::Tile;

namespace {

constexpr std::uint32_t kVersion = 1;
constexpr const char* kName = "tracker";
enum Flag : std::uint8_t { kDirty = 1, kPatched = 2, kFresh = 4 };

void put_key(io::StateWriter& to, const BlockKey& key) {
  to.put(key.x);
  to.put(key.y);
  to.put(key.z);
}

BlockKey get_key(io::StateReader& from) {
  BlockKey key;
  key.x = from.get<std::int32_t>();
  key.y = from.get<std::int32_t>();
  key.z = from.get<std::int32_t>();
  constexpr std::int32_t kMost = 1 << 30;  // neighbours have keys too
  const auto inside = [](std::int32_t v) { return v > -kMost && v < kMost; };
  from.require(inside(key.x) && inside(key.y) && inside(key.z), "a key out of range");
  return key;
}

void put_cloud(io::StateWriter& to, const PointCloud& cloud) {
  to.list(cloud.positions);
  to.list(cloud.normals);
  to.list(cloud.colors);
}

PointCloud get_cloud(io::StateReader& from, const Eigen::Vector3d& origin) {
  PointCloud cloud;
  cloud.positions = from.list<Eigen::Vector3f>();
  cloud.normals = from.list<Eigen::Vector3f>();
  cloud.colors = from.list<Rgb>();
  const std::size_t count = cloud.positions.size();
  from.require(cloud.normals.size() == count, "not one normal a point");
  from.require(cloud.colors.empty() || cloud.colors.size() == count, "not one colour a point");
  from.require(count < 0x7fffffff, "too many points");
  cloud.origin = origin;
  cloud.width = static_cast<std::uint32_t>(count);
  return cloud;
}

void put_planes(io::StateWriter& to, const std::vector<HeldPlane>& planes) {
  to.put<std::uint64_t>(planes.size());
  for (const HeldPlane& held : planes) {
    to.put(held.plane.normal);
    to.put(held.plane.distance);
    to.put<std::uint8_t>(held.selected ? 1 : 0);
  }
}

std::vector<HeldPlane> get_planes(io::StateReader& from) {
  std::vector<HeldPlane> planes(from.length(4 * sizeof(float) + 1));
  for (HeldPlane& held : planes) {
    Plane& plane = held.plane;
    plane.normal = from.get<Eigen::Vector3f>();
    plane.distance = from.get<float>();
    held.selected = from.get<std::uint8_t>() != 0;
    from.require(std::abs(plane.normal.norm() - 1) < 1e-3f && std::isfinite(plane.distance),
                 "a plane without unit normal");
  }
  return planes;
}

void put_options(io::StateWriter& to, const TrackOptions& options) {
  std::string text;
  for (const OptionInfo& info : option_table()) {
    text += info.name + "=" + get_option(options.engine, info.name) + "\n";
  }
  to.text(text);
  for (const double value : {options.tile_size, options.change, options.share}) to.put(value);
  for (const std::uint32_t value : {options.interval, options.least_points, options.steady_after}) {
    to.put(value);
  }
}

TrackOptions get_options(io::StateReader& from) {
  TrackOptions options;
  const std::string text = from.text();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::size_t sign = text.find('=', begin);
    from.require(sign < end, "an option without value");
    set_option(options.engine, text.substr(begin, sign - begin),
               text.substr(sign + 1, end - sign - 1));
    begin = end + 1;
  }
  for (double* value : {&options.tile_size, &options.change, &options.share}) {
    *value = from.get<double>();
  }
  for (std::uint32_t* value : {&options.interval, &options.least_points, &options.steady_after}) {
    *value = from.get<std::uint32_t>();
  }
  return options;
}

void put_memory(io::StateWriter& to, const track::PlaceMemory& memory) {
  std::vector<std::pair<track::VoxelKey, std::uint32_t>> places;
  for (const auto& [voxel, place] : memory) places.emplace_back(voxel, place.object);
  std::ranges::sort(places);
  to.put<std::uint64_t>(places.size());
  for (const auto& [voxel, object] : places) {
    for (const std::int32_t part : voxel) to.put(part);
    to.put(object);
  }
}

track::PlaceMemory get_memory(io::StateReader& from, std::uint32_t last_object) {
  track::PlaceMemory memory;
  const std::size_t count = from.length(16);
  for (std::size_t i = 0; i < count; ++i) {
    track::VoxelKey voxel;
    for (std::int32_t& part : voxel) part = from.get<std::int32_t>();
    const auto object = from.get<std::uint32_t>();
    from.require(object >= 1 && object <= last_object, "a place of no object");
    memory[voxel].object = object;
  }
  return memory;
}

void put_votes(io::StateWriter& to, const std::vector<std::vector<track::Vote>>& votes) {
  to.put<std::uint64_t>(votes.size());
  for (const std::vector<track::Vote>& own : votes) {
    to.put<std::uint64_t>(own.size());
    for (const track::Vote& vote : own) {
      for (const std::uint32_t part : {vote.object, vote.points, vote.steady}) to.put(part);
    }
  }
}

std::vector<std::vector<track::Vote>> get_votes(io::StateReader& from, std::uint32_t last_object) {
  std::vector<std::vector<track::Vote>> votes;
  for (std::size_t patches = from.length(8); patches > 0; --patches) {
    std::vector<track::Vote>& own = votes.emplace_back();
    for (std::size_t count = from.length(12); count > 0; --count) {
      track::Vote& vote = own.emplace_back();
      for (std::uint32_t* part : {&vote.object, &vote.points, &vote.steady}) {
        *part = from.get<std::uint32_t>();
      }
      from.require(vote.object >= 1 && vote.object <= last_object, "a vote for no object");
    }
  }
  return votes;
}

void put_tile(io::StateWriter& to, const Tile& tile) {
  to.put<std::uint64_t>(tile.pieces.size());
  for (const auto& [key, piece] : tile.pieces) {
    put_key(to, key);
    to.put(piece.times);
    put_cloud(to, piece.points);
  }
  to.put<std::uint64_t>(tile.changed);
  const int flags =
      (tile.dirty ? kDirty : 0) | (tile.patched ? kPatched : 0) | (tile.fresh ? kFresh : 0);
  to.put(static_cast<std::uint8_t>(flags));
  if (tile.patched && tile.dirty) {
    put_cloud(to, tile.patched->cloud);
    to.put<std::uint64_t>(tile.patched->pieces.size());
    for (const auto& [key, count] : tile.patched->pieces) {
      put_key(to, key);
      to.put(count);
    }
  }
  if (tile.patched && !tile.fresh) to.list(tile.objects);
  if (!tile.fresh) return;
  put_memory(to, tile.memory);
  put_votes(to, tile.votes);
}

}  // namespace

void MapTracker::write(std::ostream& stream) const {
  const State& state = *state_;
  io::StateWriter to(stream, kName, kVersion);
  put_options(to, state.options);
  to.put(state.updates);
  for (const std::uint64_t n : {state.patch_count, state.plane_count, state.segment_count}) {
    to.put(n);
  }
  to.put<std::uint8_t>(state.origin ? 1 : 0);
  for (int k = 0; k < 3; ++k) to.put(state.origin ? (*state.origin)[k] : 0.0);
  state.book.write(to);
  put_planes(to, state.held.supporting);
  put_planes(to, state.held.faces);
  to.put<std::uint64_t>(state.tiles.size());
  for (const auto& [key, tile] : state.tiles) {
    put_key(to, key);
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
  PointCloud cloud;
  std::vector<std::pair<BlockKey, std::uint32_t>> pieces;
};

void get_pieces(io::StateReader& from, const Eigen::Vector3d& origin, Stored& stored) {
  const std::size_t count = from.length(12);
  for (std::size_t i = 0; i < count; ++i) {
    const BlockKey key = get_key(from);
    Piece piece;
    piece.times = from.get<std::uint8_t>();
    piece.points = get_cloud(from, origin);
    piece.mean = track::mean_of(piece.points);
    from.require(piece.points.size() > 0, "a piece without points");
    stored.tile.points += piece.points.size();
    from.require(stored.tile.pieces.emplace(key, std::move(piece)).second, "a piece twice");
  }
}

/// The points that were patched: those of the pieces, or as they were stored.
void get_patched(io::StateReader& from, const Eigen::Vector3d& origin, Stored& stored) {
  if ((stored.flags & kDirty) == 0) {
    for (const auto& [key, piece] : stored.tile.pieces) {
      track::append(piece.points, stored.cloud);
      stored.pieces.emplace_back(key, static_cast<std::uint32_t>(piece.points.size()));
    }
    return;
  }
  stored.cloud = get_cloud(from, origin);
  const std::size_t count = from.length(16);
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const BlockKey key = get_key(from);
    const auto size = from.get<std::uint32_t>();
    points += size;
    stored.pieces.emplace_back(key, size);
  }
  from.require(points == stored.cloud.size(), "a tile whose pieces have other points than it");
}

Stored get_tile(io::StateReader& from, const Eigen::Vector3d& origin, std::uint32_t last_object) {
  Stored stored;
  stored.key = get_key(from);
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
    stored.tile.memory = get_memory(from, last_object);
    stored.tile.votes = get_votes(from, last_object);
  }
  return stored;
}

/// Patches what was patched.
void patch_again(Stored& stored, const TrackOptions& options) {
  if ((stored.flags & kPatched) == 0) return;
  Tile& tile = stored.tile;
  stored.cloud.width = static_cast<std::uint32_t>(stored.cloud.size());
  tile.patched = std::make_shared<const PatchedTile>(
      track::patch_tile(std::move(stored.cloud), std::move(stored.pieces), stored.key,
                        options.tile_size, options.engine.patches));
}

}  // namespace

MapTracker MapTracker::read(std::istream& stream, const std::string& name) try {
  io::StateReader from(stream, name, kName, kVersion);
  MapTracker tracker(get_options(from));
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
  state.held.supporting = get_planes(from);
  state.held.faces = get_planes(from);
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
  return tracker;
} catch (const Error& error) {
  if (error.kind() == Error::Kind::Input) throw;
  throw Error(Error::Kind::Input, name + ": is damaged: " + error.what());
}

}  // namespace planescope
