// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "planescope/error.hpp"

/// \file What differs between two results, on results that were made by hand.
namespace planescope {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// 100 points along x, 1 cm apart. Segment 1: the first 60, on plane 0 (z = 0); segment 2: the next
/// 30; the last 10 in none. A patch every 10 points.
Result base() {
  Result result;
  result.input_hash = "in";
  result.options_hash = "options";
  for (int i = 0; i < 100; ++i) {
    result.cloud.positions.emplace_back(0.01F * static_cast<float>(i), 0.0F, 0.0F);
    result.point_label.push_back(i < 60 ? 1 : (i < 90 ? 2 : kNoSegment));
    result.point_plane.push_back(i < 60 ? 0 : kNone);
    result.point_patch.push_back(i / 10);
  }
  result.cloud.width = 100;
  result.patch_count = 10;
  result.segments.resize(2);
  result.planes.resize(1);
  return result;
}

/// A chain of patches: ON within the segments, OFF between them.
std::vector<EdgeState> chain() {
  std::vector<EdgeState> edges;
  for (std::uint32_t i = 0; i < 9; ++i) {
    const bool border = i == 5 || i == 8;
    const EdgeRule on = i < 5 ? EdgeRule::SamePlane : EdgeRule::Convex;
    edges.push_back({i, i + 1, !border, border ? EdgeRule::PlaneBoundary : on});
  }
  return edges;
}

TEST(CompareResults, AResultIsLikeItself) {
  const ResultComparison found = compare_results(base(), chain(), base(), chain());
  EXPECT_TRUE(found.same_input);
  EXPECT_TRUE(found.same_options);
  EXPECT_EQ(found.worst(), 0);
  EXPECT_EQ(found.segments.size(), 2U);
  EXPECT_EQ(found.planes.size(), 1U);
  EXPECT_EQ(found.planes[0].angle, 0);
  EXPECT_EQ(found.edges.compared, 9U);
  EXPECT_EQ(found.scores.adjusted_rand, 1);
}

TEST(CompareResults, NamesDoNotMatter) {
  Result other = base();
  for (std::uint32_t& label : other.point_label)
    if (label != kNoSegment) label = 3 - label;
  for (std::int32_t& patch : other.point_patch) patch = 9 - patch;
  std::vector<EdgeState> edges = chain();
  for (EdgeState& edge : edges) edge = {9 - edge.second, 9 - edge.first, edge.on, edge.rule};
  const ResultComparison found = compare_results(base(), chain(), other, edges);
  EXPECT_EQ(found.worst(), 0);
  EXPECT_EQ(found.segments[0].second, 2U);
  EXPECT_EQ(found.segments[1].second, 1U);
}

TEST(CompareResults, CountsThePointsThatChangedTheirSegment) {
  Result other = base();
  // 10 of the 60 go to segment 2, and 5 of its own are lost: 15 of 90.
  for (std::size_t i = 50; i < 60; ++i) other.point_label[i] = 2;
  for (std::size_t i = 85; i < 90; ++i) other.point_label[i] = kNoSegment;
  const ResultComparison found = compare_results(base(), {}, other, {});
  EXPECT_DOUBLE_EQ(found.changed_points, 15.0 / 90);
  ASSERT_EQ(found.segments.size(), 2U);
  EXPECT_DOUBLE_EQ(found.segments[0].overlap, 50.0 / 60);
  EXPECT_DOUBLE_EQ(found.segments[1].overlap, 25.0 / 40);
  EXPECT_DOUBLE_EQ(found.worst(), found.changed_points);
}

TEST(CompareResults, AMergedSegmentIsGoneAndAHalvedOneToo) {
  Result other = base();  // one segment of all: 60 of 90 are more than half
  std::replace(other.point_label.begin(), other.point_label.end(), 2U, 1U);
  other.segments.resize(1);
  ResultComparison found = compare_results(base(), {}, other, {});
  EXPECT_EQ(found.gone_segments, std::vector<std::uint32_t>{2});
  EXPECT_TRUE(found.new_segments.empty());
  EXPECT_DOUBLE_EQ(found.changed_points, 30.0 / 90);
  other = base();  // 30 and 30 of the 60: neither is more than half
  std::fill_n(other.point_label.begin(), 30, 3U);
  other.segments.resize(3);
  found = compare_results(base(), {}, other, {});
  EXPECT_EQ(found.gone_segments, std::vector<std::uint32_t>{1});
  EXPECT_EQ(found.new_segments, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_DOUBLE_EQ(found.changed_points, 60.0 / 90);
}

TEST(CompareResults, MeasuresHowFarAPlaneMoved) {
  Result other = base();
  const float tilt = static_cast<float>(0.5 * kPi / 180);  // about the line x = 0.295, the middle
  // Turned round as well: normals point either way.
  other.planes[0].plane.normal = -Eigen::Vector3f(std::sin(tilt), 0, std::cos(tilt));
  const float lift = 0.004F;
  other.planes[0].plane.distance = -(0.295F * std::sin(tilt) + lift);
  ResultComparison found = compare_results(base(), {}, other, {});
  ASSERT_EQ(found.planes.size(), 1U);
  EXPECT_NEAR(found.planes[0].angle, 0.5, 1e-4);
  EXPECT_NEAR(found.planes[0].offset, 0.004, 1e-6);
  EXPECT_FALSE(found.planes[0].moved);
  EXPECT_EQ(found.changed_planes, 0);
  found = compare_results(base(), {}, other, {}, {.plane_angle = 0.4, .plane_offset = 0.01});
  EXPECT_TRUE(found.planes[0].moved);
  EXPECT_EQ(found.changed_planes, 1);
  found = compare_results(base(), {}, other, {}, {.plane_angle = 1, .plane_offset = 0.003});
  EXPECT_TRUE(found.planes[0].moved);
}

TEST(CompareResults, AnOriginIsNoMove) {
  Result other = base();
  const Eigen::Vector3d shift(0, 0, 5);
  other.cloud.origin = shift;
  for (Eigen::Vector3f& p : other.cloud.positions) p -= shift.cast<float>();
  other.planes[0].plane.distance = -5;
  const ResultComparison found = compare_results(base(), {}, other, {});
  EXPECT_NEAR(found.planes[0].offset, 0, 1e-6);
}

TEST(CompareResults, TellsEdgesByWhatBecameOfThem) {
  std::vector<EdgeState> edges = chain();
  edges[2].on = false;  // same plane, ON -> OFF, concave
  edges[2].rule = EdgeRule::Concave;
  edges[5].on = true;  // plane boundary, OFF -> ON, convex
  edges[5].rule = EdgeRule::Convex;
  edges[6].rule = EdgeRule::NearlyFlat;  // convex, and ON still
  edges.erase(edges.begin());            // gone
  edges.push_back({0, 9, true, EdgeRule::Convex});
  edges.push_back({1, 9, true, EdgeRule::Convex});  // two are new
  const ResultComparison found = compare_results(base(), chain(), base(), edges);
  EXPECT_EQ(found.edges.compared, 8U);
  EXPECT_EQ(found.edges.on_to_off, 1U);
  EXPECT_EQ(found.edges.off_to_on, 1U);
  EXPECT_EQ(found.edges.same_state, 1U);
  EXPECT_EQ(found.edges.gone, 1U);
  EXPECT_EQ(found.edges.added, 2U);
  const auto at = [&](EdgeRule from, EdgeRule to) {
    return found.edges.by_rule[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)];
  };
  EXPECT_EQ(at(EdgeRule::SamePlane, EdgeRule::Concave), 1U);
  EXPECT_EQ(at(EdgeRule::PlaneBoundary, EdgeRule::Convex), 1U);
  EXPECT_EQ(at(EdgeRule::Convex, EdgeRule::NearlyFlat), 1U);
  EXPECT_DOUBLE_EQ(found.changed_edges, 5.0 / 11);
}

TEST(CompareResults, RefusesOtherCloudsAndEdgesOfNoPatch) {
  Result shorter = base();
  for (auto* column : {&shorter.point_plane, &shorter.point_patch}) column->pop_back();
  shorter.point_label.pop_back();
  shorter.cloud.positions.pop_back();
  shorter.cloud.width = 99;
  EXPECT_THROW(compare_results(base(), {}, shorter, {}), Error);
  const std::vector<EdgeState> bad = {{0, 10, true, EdgeRule::Convex}};
  EXPECT_THROW(compare_results(base(), bad, base(), {}), Error);
}

TEST(CompareResults, NothingIsLikeNothing) {
  Result empty = base();
  std::fill(empty.point_label.begin(), empty.point_label.end(), kNoSegment);
  std::fill(empty.point_plane.begin(), empty.point_plane.end(), kNone);
  empty.segments.clear();
  empty.planes.clear();
  EXPECT_EQ(compare_results(empty, {}, empty, {}).worst(), 0);
  EXPECT_EQ(compare_results(empty, {}, base(), {}).changed_points, 1);
  EXPECT_EQ(compare_results(base(), {}, empty, {}).changed_planes, 1);
}

/// The share of changed points, by a second formulation over all pairs of labels.
TEST(CompareResults, AgreesWithASlowerWayOnRandomLabels) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 50; ++round) {
    Result a = base(), b = base();
    a.segments.resize(5);
    b.segments.resize(5);
    for (std::size_t i = 0; i < 100; ++i) {
      a.point_label[i] = static_cast<std::uint32_t>(random() % 6);
      b.point_label[i] =
          random() % 4 == 0 ? static_cast<std::uint32_t>(random() % 6) : (a.point_label[i] + 2) % 6;
    }
    double counted = 0, kept = 0;
    for (std::size_t i = 0; i < 100; ++i)
      counted += a.point_label[i] + b.point_label[i] > 0 ? 1 : 0;
    for (std::uint32_t x = 1; x <= 5; ++x) {
      for (std::uint32_t y = 1; y <= 5; ++y) {
        double both = 0, either = 0;
        for (std::size_t i = 0; i < 100; ++i) {
          both += a.point_label[i] == x && b.point_label[i] == y ? 1 : 0;
          either += a.point_label[i] == x || b.point_label[i] == y ? 1 : 0;
        }
        if (both > either / 2) kept += both;
      }
    }
    EXPECT_NEAR(compare_results(a, {}, b, {}).changed_points, 1 - kept / counted, 1e-12);
  }
}

}  // namespace
}  // namespace planescope
