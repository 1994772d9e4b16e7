// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
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
/// points: the piece is gone.
struct SurfacePiece {
  BlockKey key;
  PointCloud points;  ///< with normals towards the sensor and, if the first one had them, colours
};

enum class TrackEventKind {
  New,       ///< an object that no earlier one was part of
  Split,     ///< part of `object` goes on as `other`
  Merge,     ///< `other` became part of `object`
  Vanished,  ///< no surface of `object` is left
  Plane,     ///< `object` is now supported by a plane, and was not before
};
std::string_view name(TrackEventKind kind);  ///< `new`, `split`, `merge`, `vanished`, `plane`

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
  std::size_t points = 0, patches = 0, planes = 0, segments = 0;  ///< of the map
  std::size_t carried = 0;  ///< points whose place had an object before
  std::size_t kept = 0;     ///< of these: that have the same object still
  double milliseconds = 0;  ///< wall-clock time of the update
  std::vector<TrackEvent> events;
};

/// How to track.
struct TrackOptions {
  Options engine = Options::room();
  double tile_size = 0.64;  ///< [m] the map is patched in cubes of this edge, each by itself; at
                            ///< least 4 patch_size
  /// [1] a piece counts as changed where its number of points changed by this share or its mean
  /// moved by this many voxels
  double change = 0.25;
};

/// The pieces of a fused volume that may have changed since a frame (itself included): the blocks
/// that it changed, and their neighbours whose cells reach into them. By key.
std::vector<SurfacePiece> changed_pieces(const TsdfVolume& volume, std::uint32_t since);

/// The map at the end, segmented at once.
struct TrackResult {
  Segmentation scene;                  ///< what segment() says of the map
  std::vector<std::uint32_t> objects;  ///< per segment: the object's number
  TrackStep step;                      ///< how it differs from what was tracked
};

/// Takes a map piece by piece and holds its segmentation. Only tiles with changed pieces are
/// re-patched; planes, edges and segments are found over all patches, which is cheap; segments are
/// matched with the objects that their places had before. Differs from segment() of the same map
/// in that patches end at the faces of tiles: see finish(). Memory is the map's. Same pieces in the
/// same order, same result, at any number of threads.
class MapTracker {
 public:
  /// \throws Error{Kind::Usage} options are out of range.
  explicit MapTracker(const TrackOptions& options = {});
  ~MapTracker();
  MapTracker(MapTracker&&) noexcept;
  MapTracker& operator=(MapTracker&&) noexcept;

  /// Puts changed pieces into the map, and segments it. \param frame for the events.
  /// \throws Error{Kind::Input} a piece has another origin than the first one, or no normals.
  TrackStep update(std::uint32_t frame, std::span<const SurfacePiece> pieces);

  /// The same, taking every piece as changed, however little: after it the map is what was given.
  TrackStep update_exactly(std::uint32_t frame, std::span<const SurfacePiece> pieces);

  /// Segments the map so far at once, as segment() does, and names its segments after the objects:
  /// patches do not end at the faces of tiles then. Changes nothing; costs what segment() costs.
  /// \throws Error as segment() does.
  TrackResult finish(std::uint32_t frame) const;

  /// The map so far, tile by tile, and its segmentation. Segments are numbered by size, as
  /// segment() does; objects() says which object each one is. The first call after an update puts
  /// the points together; not from two threads at once.
  const PointCloud& map() const;
  const Segmentation& scene() const;
  /// Per segment: the object's number, from 1, never given twice.
  const std::vector<std::uint32_t>& objects() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace planescope
