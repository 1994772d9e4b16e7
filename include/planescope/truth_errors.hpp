// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "planescope/edges.hpp"
#include "planescope/segments.hpp"

/// \file Errors of a segmentation against the truth, one by one: edges that are ON across two
/// objects or OFF inside one, points that were merged into another object's segment or split off.
/// Labels of the truth are as score_labels() takes them; 0 is none.
namespace planescope {

/// The parts of an object merged as merge_truth() does, each object under the lowest label that it
/// may have: 0 stays 0, else label / divide * divide, and 1 for those below `divide`.
/// \throws Error{Kind::Usage} divide is 0.
std::vector<std::uint32_t> object_labels(std::vector<std::uint32_t> labels, std::uint32_t divide);

/// The true object of each patch: that of most of its points, where they are `purity` of those with
/// truth at least; else 0: the patch straddles two objects (or has no truth), and no edge of it is
/// judged. \throws Error{Kind::Input} `truth` has another length than `point_patch`.
std::vector<std::uint32_t> patch_truth(std::span<const std::int32_t> point_patch,
                                       std::span<const std::uint32_t> truth,
                                       std::size_t patch_count, double purity = 0.8);

/// What the truth says of an edge.
enum class EdgeError : std::uint8_t {
  None,      ///< ON inside one object, or OFF between two
  Merged,    ///< ON across two objects
  Cut,       ///< OFF inside one object
  Unjudged,  ///< a patch has no true object
};
inline constexpr std::size_t kEdgeErrorCount = 4;

/// `right`, `merged`, `cut`, `unjudged`.
std::string_view name(EdgeError error);

/// One entry an edge.
std::vector<EdgeError> judge_edges(const std::vector<Edge>& edges,
                                   const std::vector<std::uint32_t>& patch_truth);

/// How many edges of each kind, indexed by EdgeError.
std::array<std::size_t, kEdgeErrorCount> count_errors(const std::vector<EdgeError>& errors);

/// The edges that are wrong, worst first: those that changed the segments (ON across two objects;
/// OFF between two segments that are one object) before those that did not (the object hangs
/// together by other edges), then by the length of the shared border.
std::vector<std::size_t> wrong_edges(const std::vector<Edge>& edges,
                                     const std::vector<EdgeError>& errors,
                                     const std::vector<std::uint32_t>& patch_label);

/// What the truth says of a point.
enum class PointError : std::uint8_t {
  None,      ///< in the segment of its object: of those that mainly are the object, the one that
             ///< holds most of it
  Merged,    ///< in a segment that mainly is another object
  Split,     ///< in another segment that mainly is its object
  Missed,    ///< in no segment
  Unjudged,  ///< has no truth
};
inline constexpr std::size_t kPointErrorCount = 5;

/// `right`, `merged`, `split`, `missed`, `unjudged`.
std::string_view name(PointError error);

/// One entry a point. Merged points over all points in segments are LabelScores'
/// under_segmentation; ties are broken as there, to the lower label.
/// \throws Error{Kind::Input} different lengths.
std::vector<PointError> judge_points(std::span<const std::uint32_t> predicted,
                                     std::span<const std::uint32_t> truth);

/// How many points of each kind, indexed by PointError.
std::array<std::size_t, kPointErrorCount> count_errors(const std::vector<PointError>& errors);

}  // namespace planescope
