// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/state_stream.hpp"
#include "planescope/track.hpp"

namespace planescope::cli {

/// What a run of `track` says frame by frame.
class TrackTables {
 public:
  /// A frame that was tracked. \param fusion [ms] its fusion took.
  void add(TrackStep step, double fusion);
  /// The map, segmented at once: a last row, whose `segmented` is 2, and its events.
  void close(const TrackStep& step);
  /// A jump of the pose before a frame.
  void add_jump(std::uint32_t frame);

  /// frames.csv, events.csv and times.csv into `folder`.
  void write(const std::filesystem::path& folder) const;

  /// A line for people: times, and how steady labels were.
  std::string summary() const;

  /// What of it goes into a snapshot: all but times.
  void store(io::StateWriter& to) const;
  void restore(io::StateReader& from);

  const std::vector<TrackStep>& steps() const { return steps_; }  ///< without events
  const std::vector<double>& fusion() const { return fusion_; }   ///< [ms] one a step
  std::size_t jumps() const { return jumps_; }

 private:
  void add_row(const TrackStep& step, int segmented);

  std::string frames_ =
      "frame,segmented,pieces,changed,tiles,waiting,points,patches,planes,segments,carried,kept,"
      "steady,steady_kept\n";
  std::string events_ = "frame,event,object,other,points\n";
  std::vector<TrackStep> steps_;  // of this run; `at once` not among them
  std::vector<double> fusion_;
  TrackStep whole_;
  std::uint64_t jumps_ = 0, event_count_ = 0;
  std::uint64_t carried_ = 0, kept_ = 0, steady_ = 0, steady_kept_ = 0;
};

/// Segments of a result and the objects that they are, as CSV.
std::string objects_csv(const std::vector<std::uint32_t>& objects);

}  // namespace planescope::cli
