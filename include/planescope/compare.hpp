// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "planescope/edges.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/result.hpp"

/// \file What differs between two results of one cloud: segments, planes, edges.
namespace planescope {

/// An edge as graph.vtp has it, as far as results are compared (stored_edges() in render.hpp).
struct EdgeState {
  std::uint32_t first = 0, second = 0;  ///< patches
  bool on = false;
  EdgeRule rule = EdgeRule::Concave;
};

/// When a plane counts as moved.
struct CompareOptions {
  double plane_angle = 1.0;    ///< [deg] between the normals, either way round
  double plane_offset = 0.01;  ///< [m] between the planes at the middle of the first one's points
};

/// A segment of the first result and the one of the second that is the same thing: they share more
/// than half of what they cover together, which no other pair with one of them can (Kirillov et
/// al., "Panoptic Segmentation", CVPR 2019).
struct SegmentMatch {
  std::uint32_t first = 0, second = 0;  ///< labels
  double overlap = 0;                   ///< |A n B| / |A u B|, more than 0.5
};

/// A plane of the first result and the same one of the second, matched likewise by their points.
struct PlaneMatch {
  std::int32_t first = 0, second = 0;
  double angle = 0;   ///< [deg]
  double offset = 0;  ///< [m], see CompareOptions
  bool moved = false;
};

/// Edges of the first result by what became of them. Patches are matched as segments are, by their
/// points; an edge is compared if the second result has one between the same two patches.
struct EdgeChanges {
  std::size_t compared = 0;
  std::size_t on_to_off = 0, off_to_on = 0;
  std::size_t same_state = 0;  ///< decided by another rule, with the same outcome
  /// Number of compared edges by rule in the first result (row) and in the second (column).
  std::array<std::array<std::size_t, kEdgeRuleCount>, kEdgeRuleCount> by_rule = {};
  std::size_t gone = 0, added = 0;  ///< edges of one result only
};

/// What differs between two results.
struct ResultComparison {
  bool same_input = false;                                 ///< the input's bytes had the same hash
  bool same_options = false;                               ///< and so had the options
  std::vector<SegmentMatch> segments;                      ///< by first label, ascending
  std::vector<std::uint32_t> gone_segments, new_segments;  ///< labels of one result only
  std::vector<PlaneMatch> planes;                          ///< by first plane, ascending
  std::vector<std::int32_t> gone_planes, new_planes;
  EdgeChanges edges;
  LabelScores scores;  ///< of the second result with the first as the truth; all 1 (or 0, what is
                       ///< an error) where the first has no segment

  /// Shares that say how much changed, 0 to 1; all are 0 for results that say the same.
  double changed_points = 0;  ///< of the points in a segment of either result: those that are not
                              ///< in the matched segment
  double changed_planes = 0;  ///< of the points on a plane of either: those that are not on the
                              ///< matched plane, or on one that moved
  double changed_edges = 0;   ///< of the edges of either: those that flipped, are gone or new

  /// The largest of the shares: what a tolerance is for.
  double worst() const;
};

/// Compares two results of the same points in the same order.
/// \param a_edges,b_edges may be empty where a method has no graph.
/// \throws Error{Kind::Input} the results have different numbers of points, or an edge names a
/// patch that its result does not have.
ResultComparison compare_results(const Result& a, std::span<const EdgeState> a_edges,
                                 const Result& b, std::span<const EdgeState> b_edges,
                                 const CompareOptions& options = {});

}  // namespace planescope
