// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "planescope/compare.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

/// Regions of the same points in two results, 0 to n - 1; kNone: in no region.
struct Regions {
  std::vector<std::int32_t> first, second;
  std::size_t first_count = 0, second_count = 0;
};

struct RegionMatch {
  std::int32_t first = 0, second = 0;
  double overlap = 0;
};

/// Pairs that share more than half of their union: at most one for each region.
std::vector<RegionMatch> match(const Regions& regions) {
  std::vector<std::uint64_t> a(regions.first_count), b(regions.second_count);
  std::unordered_map<std::uint64_t, std::uint64_t> shared;
  for (std::size_t i = 0; i < regions.first.size(); ++i) {
    const std::int32_t x = regions.first[i], y = regions.second[i];
    if (x != kNone) ++a[static_cast<std::size_t>(x)];
    if (y != kNone) ++b[static_cast<std::size_t>(y)];
    if (x != kNone && y != kNone)
      ++shared[(static_cast<std::uint64_t>(x) << 32) | static_cast<std::uint32_t>(y)];
  }
  std::vector<RegionMatch> matches;
  for (const auto& [key, count] : shared) {
    const auto x = static_cast<std::size_t>(key >> 32);
    const auto y = static_cast<std::size_t>(key & 0xFFFFFFFFU);
    const std::uint64_t both = a[x] + b[y] - count;
    if (2 * count <= both) continue;
    matches.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                       static_cast<double>(count) / static_cast<double>(both)});
  }
  std::sort(matches.begin(), matches.end(),
            [](const RegionMatch& p, const RegionMatch& q) { return p.first < q.first; });
  return matches;
}

/// Index: region of the first result; its match, or kNone.
std::vector<std::int32_t> partners(const std::vector<RegionMatch>& matches, std::size_t count) {
  std::vector<std::int32_t> partner(count, kNone);
  for (const RegionMatch& m : matches) partner[static_cast<std::size_t>(m.first)] = m.second;
  return partner;
}

/// Regions of one result that no match names.
std::vector<std::int32_t> unmatched(const std::vector<RegionMatch>& matches, std::size_t count,
                                    std::int32_t RegionMatch::*side) {
  std::vector<bool> seen(count, false);
  for (const RegionMatch& m : matches) seen[static_cast<std::size_t>(m.*side)] = true;
  std::vector<std::int32_t> left;
  for (std::size_t i = 0; i < count; ++i)
    if (!seen[i]) left.push_back(static_cast<std::int32_t>(i));
  return left;
}

/// Of the points in a region of either: the share of those that are not where their partner is.
double share_changed(const Regions& regions, const std::vector<std::int32_t>& partner) {
  std::size_t counted = 0, changed = 0;
  for (std::size_t i = 0; i < regions.first.size(); ++i) {
    const std::int32_t x = regions.first[i], y = regions.second[i];
    if (x == kNone && y == kNone) continue;
    ++counted;
    const bool same = x != kNone && y != kNone && partner[static_cast<std::size_t>(x)] == y;
    changed += same ? 0 : 1;
  }
  return counted == 0 ? 0 : static_cast<double>(changed) / static_cast<double>(counted);
}

/// Labels from 1 as regions from 0.
std::vector<std::int32_t> from_labels(const std::vector<std::uint32_t>& labels) {
  std::vector<std::int32_t> regions;
  regions.reserve(labels.size());
  for (const std::uint32_t label : labels) regions.push_back(static_cast<std::int32_t>(label) - 1);
  return regions;
}

std::vector<std::uint32_t> to_labels(const std::vector<std::int32_t>& regions) {
  std::vector<std::uint32_t> labels;
  labels.reserve(regions.size());
  for (const std::int32_t region : regions)
    labels.push_back(static_cast<std::uint32_t>(region) + 1);
  return labels;
}

void compare_segments(const Result& a, const Result& b, ResultComparison& found) {
  const Regions regions{from_labels(a.point_label), from_labels(b.point_label), a.segments.size(),
                        b.segments.size()};
  const auto matches = match(regions);
  for (const RegionMatch& m : matches)
    found.segments.push_back({static_cast<std::uint32_t>(m.first) + 1,
                              static_cast<std::uint32_t>(m.second) + 1, m.overlap});
  found.gone_segments = to_labels(unmatched(matches, a.segments.size(), &RegionMatch::first));
  found.new_segments = to_labels(unmatched(matches, b.segments.size(), &RegionMatch::second));
  found.changed_points = share_changed(regions, partners(matches, a.segments.size()));
  const bool any = std::ranges::any_of(a.point_label, [](auto l) { return l != kNoSegment; });
  if (any) {
    found.scores = score_labels(b.point_label, a.point_label);
  } else {
    found.scores.weighted_overlap = found.scores.overlap = found.scores.adjusted_rand = 1;
  }
}

/// Middle of the finite points on each plane, in world coordinates [m].
std::vector<Eigen::Vector3d> middles(const Result& result) {
  std::vector<Eigen::Vector3d> sums(result.planes.size(), Eigen::Vector3d::Zero());
  std::vector<double> counts(result.planes.size(), 0);
  for (std::size_t i = 0; i < result.point_plane.size(); ++i) {
    if (result.point_plane[i] == kNone || !is_finite(result.cloud.positions[i])) continue;
    const auto plane = static_cast<std::size_t>(result.point_plane[i]);
    sums[plane] += result.cloud.positions[i].cast<double>();
    counts[plane] += 1;
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = sums[i] / std::max(counts[i], 1.0) + result.cloud.origin;
  return sums;
}

double distance_from(const Result& result, std::int32_t index, const Eigen::Vector3d& world) {
  const Plane& plane = result.planes[static_cast<std::size_t>(index)].plane;
  return plane.normal.cast<double>().dot(world - result.cloud.origin) -
         static_cast<double>(plane.distance);
}

void compare_planes(const Result& a, const Result& b, const CompareOptions& options,
                    ResultComparison& found) {
  const Regions regions{a.point_plane, b.point_plane, a.planes.size(), b.planes.size()};
  const auto matches = match(regions);
  auto partner = partners(matches, a.planes.size());
  const auto middle = middles(a);
  for (const RegionMatch& m : matches) {
    const auto first = static_cast<std::size_t>(m.first);
    const Eigen::Vector3d n = a.planes[first].plane.normal.cast<double>();
    const Eigen::Vector3d k =
        b.planes[static_cast<std::size_t>(m.second)].plane.normal.cast<double>();
    PlaneMatch pair{m.first, m.second, 0, 0, false};
    // By the sine as well: the cosine cannot tell small angles.
    pair.angle = std::atan2(n.cross(k).norm(), std::abs(n.dot(k))) * 180 / std::numbers::pi;
    const double side = n.dot(k) < 0 ? -1 : 1;
    pair.offset = std::abs(distance_from(a, m.first, middle[first]) -
                           side * distance_from(b, m.second, middle[first]));
    pair.moved = pair.angle > options.plane_angle || pair.offset > options.plane_offset;
    if (pair.moved) partner[first] = kNone;
    found.planes.push_back(pair);
  }
  found.gone_planes = unmatched(matches, a.planes.size(), &RegionMatch::first);
  found.new_planes = unmatched(matches, b.planes.size(), &RegionMatch::second);
  found.changed_planes = share_changed(regions, partner);
}

void check_edges(std::span<const EdgeState> edges, const Result& result) {
  for (const EdgeState& edge : edges) {
    if (edge.first < result.patch_count && edge.second < result.patch_count) continue;
    throw Error(Error::Kind::Input, "edge " + std::to_string(edge.first) + "-" +
                                        std::to_string(edge.second) + " of " + result.input_name +
                                        ": there are only " + std::to_string(result.patch_count) +
                                        " patches; segment the scene again");
  }
}

using PatchPair = std::pair<std::int32_t, std::int32_t>;

void compare_edges(const Result& a, std::span<const EdgeState> a_edges, const Result& b,
                   std::span<const EdgeState> b_edges, ResultComparison& found) {
  check_edges(a_edges, a);
  check_edges(b_edges, b);
  const Regions regions{a.point_patch, b.point_patch, a.patch_count, b.patch_count};
  const auto partner = partners(match(regions), a.patch_count);
  std::map<PatchPair, const EdgeState*> others;
  for (const EdgeState& edge : b_edges)
    others[std::minmax(static_cast<std::int32_t>(edge.first),
                       static_cast<std::int32_t>(edge.second))] = &edge;
  EdgeChanges& edges = found.edges;
  for (const EdgeState& edge : a_edges) {
    const auto other = others.find(std::minmax(partner[edge.first], partner[edge.second]));
    if (other == others.end()) {
      ++edges.gone;
      continue;
    }
    const EdgeState& now = *other->second;
    ++edges.compared;
    ++edges.by_rule[static_cast<std::size_t>(edge.rule)][static_cast<std::size_t>(now.rule)];
    if (edge.on != now.on) {
      ++(edge.on ? edges.on_to_off : edges.off_to_on);
    } else if (edge.rule != now.rule) {
      ++edges.same_state;
    }
  }
  edges.added = b_edges.size() - edges.compared;
  const std::size_t all = edges.compared + edges.gone + edges.added;
  if (all == 0) return;
  found.changed_edges =
      static_cast<double>(edges.on_to_off + edges.off_to_on + edges.gone + edges.added) /
      static_cast<double>(all);
}

}  // namespace

double ResultComparison::worst() const {
  return std::max({changed_points, changed_planes, changed_edges});
}

ResultComparison compare_results(const Result& a, std::span<const EdgeState> a_edges,
                                 const Result& b, std::span<const EdgeState> b_edges,
                                 const CompareOptions& options) {
  if (a.cloud.size() != b.cloud.size()) {
    throw Error(Error::Kind::Input, "a result of " + std::to_string(a.cloud.size()) +
                                        " points and one of " + std::to_string(b.cloud.size()) +
                                        "; only results of the same cloud are compared");
  }
  ResultComparison found;
  found.same_input = a.input_hash == b.input_hash;
  found.same_options = a.options_hash == b.options_hash && a.method.name == b.method.name &&
                       a.method.settings == b.method.settings;
  compare_segments(a, b, found);
  compare_planes(a, b, options, found);
  compare_edges(a, a_edges, b, b_edges, found);
  return found;
}

}  // namespace planescope
