// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace planescope {
namespace {

constexpr float kDegrees = static_cast<float>(180.0 / std::numbers::pi);

float angle_degrees(float cosine) { return std::acos(std::clamp(cosine, -1.0f, 1.0f)) * kDegrees; }

// LCCP's eq. (5): the sharper the fold, the more nearly must the patches lie across it.
float singular_limit(float normal_angle, const EdgeOptions& options) {
  return static_cast<float>(options.singular_angle /
                            (1 + std::exp(-0.25 * (double(normal_angle) - 25))));
}

// Every number that a rule may ask for.
Edge measure(const PatchGraph& graph, const Adjacency& pair, const EdgeOptions& options) {
  const Patch& a = graph.patches[pair.first];
  const Patch& b = graph.patches[pair.second];
  Edge edge;
  edge.first = pair.first;
  edge.second = pair.second;
  edge.border = pair.border;
  const Eigen::Vector3f between = a.centroid - b.centroid;
  const float length = between.norm();
  const Eigen::Vector3f d =
      length > 0 ? Eigen::Vector3f(between / length) : Eigen::Vector3f::Zero();
  const Eigen::Vector3f fold = a.normal.cross(b.normal);
  const float sine = fold.norm();
  edge.normal_angle = angle_degrees(a.normal.dot(b.normal));
  edge.convexity = (a.normal - b.normal).dot(d);
  edge.singular_angle = sine > 0 ? angle_degrees(std::abs(d.dot(fold)) / sine) : 90.0f;
  edge.singular_limit = singular_limit(edge.normal_angle, options);
  edge.step = length * std::min(std::abs(d.dot(a.normal)), std::abs(d.dot(b.normal)));
  edge.facing = -0.5f * edge.convexity * length;
  edge.step_limit = std::max(a.scale, b.scale) *
                    (sine * graph.patch_size +
                     static_cast<float>(options.smoothness_tolerance) * graph.voxel_size);
  return edge;
}

// How far `value` lies from `limit`, in units of the limit.
float relative(float value, float limit) {
  return std::abs(value - limit) / std::max(limit, std::numeric_limits<float>::min());
}

void decide_by_planes(Edge& edge, const PatchPlane& a, const PatchPlane& b) {
  edge.on = a.plane == b.plane;
  edge.rule = edge.on                                ? EdgeRule::SamePlane
              : a.plane == kNone || b.plane == kNone ? EdgeRule::PlaneBoundary
                                                     : EdgeRule::DifferentPlanes;
  edge.margin = std::min(a.margin, b.margin);
}

// Normals point nearly opposite ways: the two sides of a board or rim or, where they face each
// other by more than a step, two things with a gap between. Differs from LCCP, whose tests compare
// the direction of a fold that two nearly parallel planes do not have.
void decide_by_sides(Edge& edge) {
  edge.on = edge.facing <= edge.step_limit;
  edge.rule = edge.on ? EdgeRule::Convex : EdgeRule::Concave;
  edge.margin = relative(edge.facing, edge.step_limit);
}

// LCCP without support: what the two patches alone say.
void decide_by_convexity(Edge& edge, const EdgeOptions& options) {
  const auto tolerance = static_cast<float>(options.concavity_tolerance);
  if (edge.normal_angle > static_cast<float>(options.rim_angle)) return decide_by_sides(edge);
  if (edge.singular_angle < edge.singular_limit) {
    edge.rule = EdgeRule::Singular;
    edge.margin = relative(edge.singular_angle, edge.singular_limit);
  } else if (edge.step > edge.step_limit) {
    edge.rule = EdgeRule::Step;
    edge.margin = relative(edge.step, edge.step_limit);
  } else if (edge.convexity >= 0) {
    edge.rule = EdgeRule::Convex;
    edge.margin = edge.convexity;  // the threshold is zero: the measure itself, between 0 and 2
  } else if (edge.normal_angle < tolerance) {
    edge.rule = EdgeRule::NearlyFlat;
    edge.margin = relative(edge.normal_angle, tolerance);
  } else {
    edge.rule = EdgeRule::Concave;
    edge.margin = std::min(-edge.convexity, relative(edge.normal_angle, tolerance));
  }
  edge.on = edge.rule == EdgeRule::Convex || edge.rule == EdgeRule::NearlyFlat;
}

bool by_convexity(EdgeRule rule) {
  return rule != EdgeRule::SamePlane && rule != EdgeRule::DifferentPlanes &&
         rule != EdgeRule::PlaneBoundary;
}

// Common neighbours of an edge's patches that both hold to by ON edges of convexity. Rows are
// ascending: one merge.
std::uint32_t count_support(const NeighbourTable& table, const std::vector<Edge>& edges,
                            const Edge& edge) {
  const auto joined = [&](std::uint32_t k) {
    const Edge& other = edges[table.edges[k]];
    return other.on && by_convexity(other.rule);
  };
  std::uint32_t i = table.offsets[edge.first], j = table.offsets[edge.second], support = 0;
  const std::uint32_t i_end = table.offsets[edge.first + std::size_t{1}];
  const std::uint32_t j_end = table.offsets[edge.second + std::size_t{1}];
  while (i < i_end && j < j_end) {
    if (table.neighbours[i] < table.neighbours[j]) {
      ++i;
    } else if (table.neighbours[j] < table.neighbours[i]) {
      ++j;
    } else {
      support += joined(i) && joined(j) ? 1 : 0;
      ++i;
      ++j;
    }
  }
  return support;
}

}  // namespace

std::string_view name(EdgeRule rule) {
  constexpr std::array<std::string_view, kEdgeRuleCount> names = {
      "same_plane", "different_planes", "plane_boundary", "convex",    "nearly_flat",
      "concave",    "singular",         "step",           "no_support"};
  return names[static_cast<std::size_t>(rule)];
}

std::vector<Edge> classify_edges(const PatchGraph& graph,
                                 const std::vector<PatchPlane>& patch_plane,
                                 const EdgeOptions& options) {
  std::vector<Edge> edges(graph.adjacency.size());
  const tbb::blocked_range<std::size_t> all(0, edges.size(), 4096);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t e = range.begin(); e != range.end(); ++e) {
      edges[e] = measure(graph, graph.adjacency[e], options);
      const PatchPlane& a = patch_plane[edges[e].first];
      const PatchPlane& b = patch_plane[edges[e].second];
      if (a.plane == kNone && b.plane == kNone) {
        decide_by_convexity(edges[e], options);
      } else {
        decide_by_planes(edges[e], a, b);
      }
    }
  });
  // Support is counted on what the pairs alone said, then taken away all at once: the order of
  // edges does not matter.
  const NeighbourTable table = make_neighbour_table(graph.patches.size(), graph.adjacency);
  std::vector<std::uint32_t> support(edges.size());
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t e = range.begin(); e != range.end(); ++e) {
      support[e] = count_support(table, edges, edges[e]);
    }
  });
  for (std::size_t e = 0; e < edges.size(); ++e) {
    edges[e].support = support[e];
    if (!options.extended_convexity || support[e] > 0 || !edges[e].on) continue;
    if (!by_convexity(edges[e].rule)) continue;
    edges[e].on = false;
    edges[e].rule = EdgeRule::NoSupport;
    edges[e].margin = 1;  // a whole neighbour is missing
  }
  return edges;
}

std::array<std::size_t, kEdgeRuleCount> count_rules(const std::vector<Edge>& edges) {
  std::array<std::size_t, kEdgeRuleCount> counts{};
  for (const Edge& edge : edges) ++counts[static_cast<std::size_t>(edge.rule)];
  return counts;
}

}  // namespace planescope
