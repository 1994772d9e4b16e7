// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/fusion.hpp"
#include "planescope/options.hpp"
#include "planescope/pipeline.hpp"

/// \file Segmentation that grows with the scan: a map is given piece by piece as it changes, and
/// what was found so far keeps its number.
namespace planescope {

/// A piece of the map's surface that is new or has changed: the points of one block of a fused
/// volume, of one cell of a surfel map. It replaces what was given under the same key before; no
/// points: the piece is gone. A loop closure that moves the map gives the moved pieces anew.
struct SurfacePiece {
  BlockKey key;
  PointCloud points;  ///< with normals towards the sensor; with colours, or not
};

enum class TrackEventKind {
  New,       ///< an object that no earlier one was part of
  Split,     ///< part of `object` goes on as `other`, which is new
  Merge,     ///< `other` became part of `object`
  Moved,     ///< part of `object` is now of `other`; both go on
  Vanished,  ///< no surface of `object` is left
  Plane,     ///< `object` is now supported by a plane, and was not before
};
std::string_view name(TrackEventKind kind);  ///< `new`, `split`, `merge`, `moved`, `vanished`, ...

/// Every point that changed its object is in a Split, a Merge or a Moved: their points add up to
/// TrackStep::carried - kept.
struct TrackEvent {
  std::uint32_t frame = 0;
  TrackEventKind kind = TrackEventKind::New;
  std::uint32_t object = 0, other = 0;  ///< numbers of objects, from 1; 0: none
  std::uint32_t points = 0;             ///< that the event concerns
};

/// What one update did.
struct TrackStep {
  std::uint32_t frame = 0;
  std::size_t pieces = 0;   ///< given
  std::size_t changed = 0;  ///< of these: that differed enough to matter
  std::size_t tiles = 0;    ///< re-patched
  std::size_t waiting = 0;  ///< tiles that have changed and wait for a later update
  bool segmented = false;   ///< planes, edges and segments were found anew
  std::size_t points = 0, patches = 0, planes = 0, segments = 0;  ///< of the last segmentation
  std::size_t carried = 0;      ///< points whose place had an object before; where segmented
  std::size_t kept = 0;         ///< of these: that have the same object still
  std::size_t steady = 0;       ///< of `carried`: whose piece was given steady_after times or more
  std::size_t steady_kept = 0;  ///< of these: that have the same object still
  double milliseconds = 0;      ///< wall-clock time of the update
  std::vector<TrackEvent> events;
};

/// How to track. The defaults do all work in each update. A live system spreads it: `interval`
/// updates share one segmentation. The last three of them (fewer where there are fewer, but for the
/// first) do a stage of it each; those before them re-patch at most `share` of the map each. So all
/// of them take about as long.
struct TrackOptions {
  Options engine = Options::room();
  double tile_size = 0.64;  ///< [m] the map is patched in cubes of this edge, each by itself; at
                            ///< least 4 patch_size
  /// [1] a piece counts as changed where its number of points changed by this share or its mean
  /// moved by this many voxels
  double change = 0.25;
  std::uint32_t interval = 1;  ///< planes, edges and segments are there after every such update
  /// [1] of the map's points that one update re-patches at most, the tiles first that have changed
  /// most; the others wait. 1: all tiles that have changed.
  double share = 1;
  std::uint32_t least_points = 20'000;  ///< that may be re-patched however small the map is
  std::uint32_t steady_after = 10;      ///< for TrackStep::steady; 1 to 255
};

/// The pieces of a fused volume that may have changed since a frame (itself included): the blocks
/// that it changed, and their neighbours whose cells reach into them. By key.
std::vector<SurfacePiece> changed_pieces(const TsdfVolume& volume, std::uint32_t since);

/// The map so far, segmented at once.
struct TrackResult {
  PointCloud map;                      ///< all pieces, tile by tile
  Segmentation scene;                  ///< what segment() says of the map
  std::vector<std::uint32_t> objects;  ///< per segment: the object's number
  TrackStep step;                      ///< how it differs from what was tracked
};

/// Takes a map piece by piece and holds its segmentation. Only tiles with changed pieces are
/// re-patched; planes are sought from those held so far; edges and segments are found over all
/// patches, which is cheap; segments are matched with the objects that their places had before.
/// Differs from segment() of the same map in that patches end at the faces of tiles: see finish().
/// Memory is the map's, whatever the number of updates. Same pieces in the same order, same result,
/// at any number of threads. One thread at a time.
class MapTracker {
 public:
  /// \throws Error{Kind::Usage} options are out of range.
  explicit MapTracker(const TrackOptions& options = {});
  ~MapTracker();
  MapTracker(MapTracker&&) noexcept;
  MapTracker& operator=(MapTracker&&) noexcept;

  /// Puts changed pieces into the map, re-patches and, every `interval` updates, segments it.
  /// \param frame for the events.
  /// \throws Error{Kind::Input} a piece has another origin than the first one, or no normals.
  TrackStep update(std::uint32_t frame, std::span<const SurfacePiece> pieces);

  /// The same, taking every piece as changed, however little: after it the map is what was given.
  TrackStep update_exactly(std::uint32_t frame, std::span<const SurfacePiece> pieces);

  /// Segments the map so far at once, as segment() does, and names its segments after the objects:
  /// patches do not end at the faces of tiles then, and nothing waits. Changes nothing; costs what
  /// segment() costs. \param pieces stand in place of what was given under their keys, because
  /// update() leaves small changes out: with all pieces of a volume the map is exactly the
  /// volume's. \throws Error as segment() and update() do.
  TrackResult finish(std::uint32_t frame, std::span<const SurfacePiece> pieces = {}) const;

  /// The map of the last segmentation, tile by tile, and the segmentation itself. Segments are
  /// numbered by size, as segment() does; objects() says which object each one is. The first call
  /// after an update puts the points together. Empty after read(), until the next segmentation.
  const PointCloud& map() const;
  const Segmentation& scene() const;
  /// Per segment: the object's number, from 1, never given twice.
  const std::vector<std::uint32_t>& objects() const noexcept;

  const TrackOptions& options() const noexcept;

  /// Writes all that later updates depend on, as bytes (src/track/snapshot.cpp has the layout): a
  /// tracker that was read back goes on to the same results. Check the stream afterwards.
  void write(std::ostream& to) const;
  /// Reads what write() wrote; untrusted. \param from can be sought in. \param name of the stream,
  /// for messages. \throws Error{Kind::Input} it is cut short, damaged, of another version or byte
  /// order.
  static MapTracker read(std::istream& from, const std::string& name);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace planescope
