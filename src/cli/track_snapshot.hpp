// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/track_tables.hpp"
#include "planescope/fusion.hpp"
#include "planescope/sequence.hpp"
#include "planescope/track.hpp"

/// \file snapshot.bin: where a run of `track` stood after a frame, so that another goes on from
/// there to the same bytes. Sections one after the other (io/state_stream.hpp, which has the
/// layout of a section):
///   `track`   the camera: width, height (u32), fx, fy, cx, cy, depth_scale, min_depth, max_depth
///             (f64); the frames done: u64 count, each: number u32, camera to world, 3 x 4 f64 by
///             rows; tables: two texts and 6 u64 (TrackTables::store); the pictures taken: u64
///             count, each a text
///   `volume`  fusion/volume_file.cpp
///   `tracker` track/snapshot.cpp
/// Its size is the map's: about 11 kB a block of 8 x 8 x 8 fusion voxels.
namespace planescope::cli {

inline constexpr const char* kSnapshotFile = "snapshot.bin";

/// What a run of `track` carries from frame to frame.
struct TrackRun {
  TsdfVolume volume;
  MapTracker tracker;
  TrackTables tables;
  std::size_t done = 0;                    ///< frames of the sequence
  std::vector<std::string> pictures = {};  ///< encoded, of the animation
};

/// Writes snapshot.bin into `folder`, whole or not at all.
/// \throws Error{Kind::Input} it cannot be written.
void write_snapshot(const TrackRun& run, const Sequence& sequence,
                    const std::filesystem::path& folder);

/// Reads snapshot.bin of a folder, untrusted. \param sequence must begin with the frames of the
/// snapshot, at the same poses. \param options,fusion what the run is asked for; the snapshot's
/// must be the same.
/// \throws Error{Kind::Input} missing, damaged, or of another sequence: frames were left out, or
/// poses have been given anew (a loop was closed), which moves what is fused already;
/// \throws Error{Kind::Usage} an option differs.
TrackRun read_snapshot(const std::filesystem::path& folder, const Sequence& sequence,
                       const TrackOptions& options, const FusionOptions& fusion);

}  // namespace planescope::cli
