// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>

#include "planescope/error.hpp"
#include "track/tracker_state.hpp"

namespace planescope {

using track::Piece;
using track::Tile;

namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

bool equal(const PointCloud& a, const PointCloud& b) {
  return a.positions == b.positions && a.normals == b.normals && a.colors == b.colors;
}

void check(const TrackOptions& options) {
  options.engine.validate();
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw Error(Error::Kind::Usage, "tracking: " + what);
  };
  require(options.tile_size >= 4 * options.engine.patches.patch_size && options.tile_size <= 100,
          "the tile size is " + std::to_string(options.tile_size) +
              " m; expected at least 4 patches.patch_size, at most 100");
  require(options.change > 0 && options.change <= 1,
          "the change is " + std::to_string(options.change) + "; expected more than 0, at most 1");
  require(options.interval >= 1, "the interval is 0; expected at least 1");
  require(options.share > 0 && options.share <= 1,
          "the share is " + std::to_string(options.share) + "; expected more than 0, at most 1");
  require(options.steady_after >= 1 && options.steady_after <= 255,
          "steady_after is " + std::to_string(options.steady_after) + "; expected 1 to 255");
  require(options.engine.patches.range_exponent == 0,
          "patches.range_exponent is not 0: a map has no single sensor");
}

}  // namespace

std::string_view name(TrackEventKind kind) {
  constexpr std::array<std::string_view, 6> kNames = {"new",   "split",    "merge",
                                                      "moved", "vanished", "plane"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

constexpr std::size_t kStages = 3;  // of a segmentation: State::run_stage()

/// What one of the updates that share a segmentation does. The last ones, up to three of them, have
/// its stages, as evenly as can be; those before them patch. A single one does everything.
struct Shares {
  bool patches = true;
  std::size_t first_stage = 0, end_stage = 0;  ///< stages of this update; of all so far: the end

  Shares(std::uint64_t updates, std::uint64_t interval) {
    const std::uint64_t place = (updates + interval - 1) % interval;  // from 0
    const std::uint64_t with_stages =
        std::clamp<std::uint64_t>(interval - 1, 1, std::uint64_t{kStages});
    const std::uint64_t before = interval - with_stages;
    patches = interval == 1 || place < before;
    if (place < before) return;
    first_stage = (place - before) * kStages / with_stages;
    end_stage = (place - before + 1) * kStages / with_stages;
  }
};

}  // namespace

/// After reading: runs the stages that were done of a segmentation under way. They find what they
/// found: tiles are as they were when it began.
void MapTracker::State::take_up_job() {
  const Shares last(updates, options.interval);
  if (last.end_stage == kStages) return;  // also before the first update
  TrackStep nobody_asks;
  for (std::size_t s = 0; s < last.end_stage; ++s) run_stage(s, nobody_asks);
}

MapTracker::State::State(const TrackOptions& chosen) : options(chosen) {
  planescope::check(options);
  scene.options = options.engine;
}

/// The piece's mean. \throws Error{Kind::Input} the piece does not fit the map.
Eigen::Vector3d MapTracker::State::checked_mean(const SurfacePiece& piece) const {
  if (piece.points.positions.empty()) return Eigen::Vector3d::Zero();
  if (piece.points.normals.size() != piece.points.size()) {
    throw Error(Error::Kind::Input, "tracking: a piece of the map has no normals");
  }
  if (origin && piece.points.origin != *origin) {
    throw Error(Error::Kind::Input, "tracking: a piece has another origin than the first one");
  }
  Eigen::Vector3d mean = track::mean_of(piece.points);
  if (!(mean.cwiseAbs().maxCoeff() < 1e9 * options.tile_size)) {
    throw Error(Error::Kind::Input, "tracking: a piece lies a billion tiles away from the origin");
  }
  return mean;
}

/// The tile of a piece: the one that it is in as long as it lies there but for a few voxels.
BlockKey MapTracker::State::place(const Eigen::Vector3d& mean, const BlockKey* before) const {
  const Eigen::Vector3d at = mean / options.tile_size;
  if (before != nullptr) {
    const Eigen::Array3d local = (at - Eigen::Vector3d(before->x, before->y, before->z)).array();
    const double slack = 2 * options.engine.patches.voxel_size / options.tile_size;
    if ((local >= -slack).all() && (local < 1 + slack).all()) return *before;
  }
  const auto part = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
  return {part(at.x()), part(at.y()), part(at.z())};
}

void MapTracker::State::remove(const BlockKey& key, Tile& tile) {
  const auto found = tile.pieces.find(key);
  const std::size_t count = found->second.points.size();
  tile.dirty = true;
  tile.steady.clear();
  tile.changed += count;
  tile.points -= count;
  point_count -= count;
  tile.pieces.erase(found);
}

/// Puts a piece into its tile. \returns whether that changed the map.
bool MapTracker::State::put(const SurfacePiece& piece, const Eigen::Vector3d& mean, bool exactly) {
  const PointCloud& now = piece.points;
  const auto known = home_of.find(piece.key);
  if (known == home_of.end() && now.positions.empty()) return false;
  std::uint8_t times = 1;
  if (known != home_of.end()) {
    Piece& old = *known->second.piece;
    if (old.times < 255) ++old.times;
    times = old.times;
    const auto before = static_cast<double>(old.points.size());
    const auto after = static_cast<double>(now.size());
    const bool differs =
        std::abs(after - before) > options.change * std::max(before, after) ||
        (mean - old.mean).norm() > options.change * options.engine.patches.voxel_size;
    const bool takes = exactly ? !equal(old.points, now) : differs;
    Tile* tile = takes || times == options.steady_after ? &tiles.at(known->second.tile) : nullptr;
    if (times == options.steady_after) tile->steady.clear();
    if (!takes) return false;
    remove(piece.key, *tile);
  }
  if (now.positions.empty()) {
    home_of.erase(known);
    return true;
  }
  const BlockKey key = place(mean, known == home_of.end() ? nullptr : &known->second.tile);
  Tile& tile = tiles[key];
  tile.dirty = true;
  tile.points += now.size();
  tile.changed += now.size();
  point_count += now.size();
  Piece& own = tile.pieces[piece.key];
  own = {.points = now, .mean = mean, .times = times};
  home_of[piece.key] = {key, &own};
  return true;
}

TrackStep MapTracker::State::update(std::uint32_t frame, std::span<const SurfacePiece> pieces,
                                    bool exactly) {
  const auto start = std::chrono::steady_clock::now();
  TrackStep step;
  step.frame = frame;
  step.pieces = pieces.size();
  std::vector<Eigen::Vector3d> means;
  for (const SurfacePiece& piece : pieces) {  // all, before any is put
    means.push_back(checked_mean(piece));
    if (!origin && !piece.points.positions.empty()) origin = piece.points.origin;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    step.changed += put(pieces[i], means[i], exactly) ? 1 : 0;
  }
  ++updates;
  const Shares shares(updates, options.interval);
  if (shares.patches) step.tiles = repatch();
  for (std::size_t s = shares.first_stage; s < shares.end_stage; ++s) run_stage(s, step);
  const auto is_dirty = [](const auto& entry) { return entry.second.dirty; };
  step.waiting = static_cast<std::size_t>(std::ranges::count_if(tiles, is_dirty));
  step.points = point_count;
  step.patches = patch_count;
  step.planes = plane_count;
  step.segments = segment_count;
  step.milliseconds = milliseconds_since(start);
  return step;
}

MapTracker::MapTracker(const TrackOptions& options) : state_(std::make_unique<State>(options)) {}

MapTracker::~MapTracker() = default;
MapTracker::MapTracker(MapTracker&&) noexcept = default;
MapTracker& MapTracker::operator=(MapTracker&&) noexcept = default;

TrackStep MapTracker::update(std::uint32_t frame, std::span<const SurfacePiece> pieces) {
  return state_->update(frame, pieces, false);
}

TrackStep MapTracker::update_exactly(std::uint32_t frame, std::span<const SurfacePiece> pieces) {
  return state_->update(frame, pieces, true);
}

TrackResult MapTracker::finish(std::uint32_t frame, std::span<const SurfacePiece> pieces) const {
  const auto start = std::chrono::steady_clock::now();
  TrackResult result = state_->finish(frame, pieces);
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

const TrackOptions& MapTracker::options() const noexcept { return state_->options; }

}  // namespace planescope
