// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "io/state_stream.hpp"
#include "planescope/track.hpp"

namespace planescope::track {

/// Points of one segment that were of one object before.
struct Overlap {
  std::uint32_t segment = 0;  ///< index
  std::uint32_t object = 0;
  std::uint32_t points = 0;
  std::uint32_t steady = 0;  ///< of the points: in pieces that were given often
};

/// Adds up overlaps.
class OverlapSums {
 public:
  void add(const Overlap& part);
  std::vector<Overlap> list() const;  ///< by segment, then object

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, Overlap> sums_;
};

/// The numbers that objects keep.
class ObjectBook {
 public:
  /// Matches segments with the objects before, largest overlap first (ties to the lower segment,
  /// then object), each once; a match needs a fifth of the object's surviving points or of the
  /// segment's. What is left over is new. Adds events, one for each overlap that changes its
  /// object, and counts what was kept. \returns per segment: its object.
  std::vector<std::uint32_t> match(const std::vector<Segment>& segments,
                                   const std::vector<Overlap>& overlaps, TrackStep& step);

  std::uint32_t last() const { return last_; }  ///< highest number given so far

  void write(io::StateWriter& to) const;
  /// \throws Error{Kind::Input} damaged.
  static ObjectBook read(io::StateReader& from);

 private:
  std::uint32_t last_ = 0;
  std::set<std::uint32_t> alive_;      ///< objects of the last step
  std::set<std::uint32_t> supported_;  ///< those that have had a plane
};

}  // namespace planescope::track
