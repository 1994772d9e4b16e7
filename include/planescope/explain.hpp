// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "planescope/pipeline.hpp"
#include "planescope/truth_errors.hpp"

/// \file Why an edge is ON or OFF, and what would flip it. Edges are named by their index into
/// Segmentation::edges, patches by their number.
namespace planescope {

/// A measured value beside the threshold that it is compared with.
struct Measure {
  std::string name;      ///< `normal angle`
  std::string unit;      ///< `deg`, `m`, or empty
  double value = 0;      ///< as measured
  double threshold = 0;  ///< that it is compared with
  bool above = false;    ///< true: the edge stays ON if value >= threshold; false: if below
  bool holds = false;    ///< what keeps the edge ON holds
  bool decided = false;  ///< the rule went by this value
  std::string option;    ///< that sets the threshold; empty: none does
};

/// A patch as an explanation shows it.
struct PatchReport {
  std::uint32_t id = 0;
  Patch patch;
  std::uint32_t segment = kNoSegment;
  std::uint32_t truth = 0;       ///< its true object (patch_truth()); 0: none, or not given
  std::int32_t plane = kNone;    ///< its supporting plane
  std::int32_t nearest = kNone;  ///< that, or on none: the plane it came nearest to, if any passes
                                 ///< the normal gate
  double distance = 0;           ///< [m] of its centroid from `nearest`
  double distance_limit =
      0;                     ///< [m] 2 sigma, times the patch's scale: beyond it no plane is better
  double normal_cosine = 0;  ///< |n . n_p| with `nearest`
  float margin = 0;          ///< PatchPlane::margin
};

/// An option and the value to set it to.
struct Setting {
  std::string option;  ///< `edges.concavity_tolerance`
  std::string from;    ///< its value now
  std::string to;      ///< the value that flips
};

/// What a change of options would do, as a run with it showed.
struct Flip {
  std::vector<Setting> settings;                  ///< one, or several that are needed together
  EdgeRule rule = EdgeRule::Concave;              ///< that decides the edge then
  std::size_t switched_on = 0, switched_off = 0;  ///< edges of the whole scene that flip, this one
                                                  ///< among them
  std::size_t planes = 0, segments = 0;           ///< of the scene then
};

/// Whether to look for what would change a decision: it may take a run for each value that is
/// tried.
enum class Flips { Seek, Skip };

/// Everything about one edge.
struct EdgeExplanation {
  std::size_t index = 0;  ///< into Segmentation::edges
  Edge edge;
  PatchReport first, second;
  std::vector<Measure> measures;          ///< in the order in which they are asked
  std::vector<Flip> flips;                ///< smallest changes first
  EdgeError error = EdgeError::Unjudged;  ///< where the truth was given (set_truth())
  std::string words;                      ///< explain(scene, edge)
};

/// The index of the edge between two patches. \throws Error{Kind::Usage} there is none: says which
/// neighbours they have.
std::size_t find_edge(const Segmentation& scene, std::uint32_t a, std::uint32_t b);

/// The `count` edges with the smallest margins, weakest first.
std::vector<std::size_t> weakest_edges(const Segmentation& scene, std::size_t count);

/// The `count` edges whose middles lie nearest to a place [m, relative to the cloud's origin].
std::vector<std::size_t> edges_near(const Segmentation& scene, const Eigen::Vector3f& place,
                                    std::size_t count);

/// What holds a segment together and what bounds it, each weakest first.
struct SegmentEdges {
  std::vector<std::size_t> inside;  ///< ON edges between its patches
  std::vector<std::size_t> border;  ///< OFF edges between it and others
};
/// \throws Error{Kind::Usage} there is no such segment.
SegmentEdges edges_of_segment(const Segmentation& scene, std::uint32_t label);

/// The patch whose centroid is nearest to a place. \throws Error{Kind::Usage} there is no patch.
std::uint32_t patch_at(const Segmentation& scene, const Eigen::Vector3f& place);

/// How two patches hang together.
struct Chain {
  std::vector<std::uint32_t> patches;  ///< from the one to the other
  std::vector<std::size_t> edges;      ///< between them, in that order
  bool joined = false;  ///< all are ON. Else no chain of ON edges joins them, and this one has as
                        ///< few OFF edges as possible
  bool one_segment = false;  ///< the patches are in one segment; where not `joined`: because
                             ///< segments.min_patches put a speck to its neighbour
};

/// Of all chains of ON edges between two patches one whose smallest margin is as large as possible
/// (the widest path, along the maximum spanning tree): every other has a link that is as weak. The
/// edge with that margin is what joined them.
/// Where none joins them: a chain with as few OFF edges as possible, of these the one whose OFF
/// edges have the smallest sum of margins.
/// \throws Error{Kind::Usage} no such patch, both are one, or the graph does not connect them.
Chain chain_between(const Segmentation& scene, std::uint32_t from, std::uint32_t to);

/// The edges that decide what a chain means, weakest first: of a joined one all, else those that
/// are OFF.
std::vector<std::size_t> deciding_edges(const Segmentation& scene, const Chain& chain);

/// How much of a scene is wrong.
struct ErrorSummary {
  std::array<std::size_t, kEdgeErrorCount> edges{};  ///< by EdgeError
  /// By rule: ON across two objects, and OFF inside one.
  std::array<std::size_t, kEdgeRuleCount> merged_by_rule{}, cut_by_rule{};
  std::size_t harmless_cuts = 0;  ///< OFF inside one object that hangs together by other edges
  std::array<std::size_t, kPointErrorCount> points{};  ///< by PointError
};
/// \param errors of judge_edges(); \param truth labels of the points.
ErrorSummary summarise_errors(const Segmentation& scene, const std::vector<EdgeError>& errors,
                              const std::vector<std::uint32_t>& truth);

/// Explains edges of one scene. Runs of the method's later stages with changed options are kept, so
/// that many edges cost little more than one.
class EdgeExplainer {
 public:
  /// The scene must outlive it.
  explicit EdgeExplainer(const Segmentation& scene);
  ~EdgeExplainer();
  EdgeExplainer(const EdgeExplainer&) = delete;
  EdgeExplainer& operator=(const EdgeExplainer&) = delete;

  /// Explanations then say which edges are wrong. \param labels of patch_truth(), one a patch.
  void set_truth(std::vector<std::uint32_t> labels);

  /// \param with_flips what would flip the edge. Options of `edges.*` by the measured values, then
  /// by a run of classify_edges(); options of `planes.*`, by which a patch would change its plane,
  /// by runs of selection and assignment on a ladder of values up to four times larger and smaller.
  /// \throws Error{Kind::Usage} the index is out of range, or the method is a peer, whose edges
  /// planescope did not decide.
  EdgeExplanation operator()(std::size_t index, Flips with_flips = Flips::Seek);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// An explanation in words: a dozen lines.
std::string describe(const EdgeExplanation& explanation);
/// What a chain says, in a line or two.
std::string describe(const Segmentation& scene, const Chain& chain);
std::string describe(const ErrorSummary& summary);

}  // namespace planescope
