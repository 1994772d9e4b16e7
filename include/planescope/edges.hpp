// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "planescope/options.hpp"
#include "planescope/patches.hpp"

/// \file Section III-B of the paper, eq. (1): every edge of the patch graph is ON (same object) or
/// OFF.
namespace planescope {

/// The rule that decided an edge.
enum class EdgeRule : std::uint8_t {
  SamePlane,        ///< ON: both patches lie on the same supporting plane
  DifferentPlanes,  ///< OFF: they lie on two
  PlaneBoundary,    ///< OFF: one lies on a plane, the other on none
  Convex,           ///< ON: neither on a plane, the surface bends away from the viewer, or they
                    ///< are the two sides of a board
  NearlyFlat,       ///< ON: concave, by less than the tolerance
  Concave,          ///< OFF: concave, or facing each other across a gap
  Singular,         ///< OFF: the patches touch in one place only (LCCP's sanity criterion)
  Step,             ///< OFF: a step between parallel surfaces (LCCP's smoothness)
  NoSupport,        ///< OFF: convex, but no common neighbour is convex to both (extended convexity)
};
inline constexpr std::size_t kEdgeRuleCount = 9;

/// `same_plane`, `different_planes`, ... as in result.json.
std::string_view name(EdgeRule rule);

/// An edge with its state, the rule that decided, and the numbers that it was decided on. All are
/// measured for every edge, whatever the rule.
struct Edge {
  std::uint32_t first = 0, second = 0;  ///< patches, first < second
  std::uint32_t border = 0;             ///< length of the shared border [voxel pairs]
  bool on = false;
  EdgeRule rule = EdgeRule::Concave;
  float normal_angle = 0;  ///< [deg] between n_i and n_j
  float convexity = 0;  ///< [1] (n_i - n_j) . d, d the unit vector from c_j to c_i: >= 0 is convex
  float singular_angle = 0;  ///< [deg] between d and n_i x n_j, in [0, 90]
  float singular_limit = 0;  ///< [deg] below it the edge is singular
  float step = 0;  ///< [m] step: the smaller of |d . n_i|, |d . n_j| times the centroids' distance
  float step_limit = 0;  ///< [m] beyond it the edge is a step
  /// [m] how far the patches lie in front of each other, -convexity / 2 times the centroids'
  /// distance: negative back to back
  float facing = 0;
  std::uint32_t support = 0;  ///< common neighbours that are convex to both
  /// How far the deciding value lay from its threshold, as a fraction of the threshold; 0 is
  /// undecided. For the plane rules: the smaller `plane_margin` of the two patches.
  float margin = 0;
};

/// Which plane a patch lies on, and how surely.
struct PatchPlane {
  std::int32_t plane = kNone;  ///< supporting plane, or kNone
  float margin =
      0;  ///< |U - 2| / 2 of eq. (10) for its plane or, on none, for the best one; in [0, 1]
};

/// Classifies every edge of the graph by eq. (1), in the order of `graph.adjacency`.
/// \param patch_plane one entry a patch.
std::vector<Edge> classify_edges(const PatchGraph& graph,
                                 const std::vector<PatchPlane>& patch_plane,
                                 const EdgeOptions& options);

/// Number of edges by rule, indexed by EdgeRule.
std::array<std::size_t, kEdgeRuleCount> count_rules(const std::vector<Edge>& edges);

}  // namespace planescope
