// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planescope/edges.hpp"

namespace planescope {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

using V3 = Eigen::Vector3f;

Eigen::Vector3f tilted(double degrees) {  // from +z towards +x
  return {float(std::sin(degrees * kRadians)), 0, float(std::cos(degrees * kRadians))};
}

// Patch 0 at the origin, patch 1 at `centroid`; no third patch, so extended convexity is off.
struct Pair {
  PatchGraph graph;
  EdgeOptions options;
  std::vector<PatchPlane> planes = {{kNone, 0.4f}, {kNone, 0.7f}};

  Pair(const Eigen::Vector3f& n0, const Eigen::Vector3f& n1,
       const Eigen::Vector3f& centroid = {1, 0, 0}) {
    graph.patches.resize(2);
    graph.patches[0].normal = n0;
    graph.patches[1].normal = n1;
    graph.patches[1].centroid = centroid;
    graph.adjacency = {{0, 1, 5}};
    graph.voxel_size = 0.01f;
    graph.patch_size = 2.0f;      // steps do not decide unless a test says so
    options.singular_angle = 60;  // these two are LCCP's own
    options.smoothness_tolerance = 0.1;
  }

  Edge classify() const { return classify_edges(graph, planes, options).front(); }
};

TEST(Edges, OnOnePlaneIsOn) {
  Pair pair(tilted(0), tilted(80));
  pair.planes = {{3, 0.4f}, {3, 0.7f}};
  const Edge edge = pair.classify();
  EXPECT_TRUE(edge.on);
  EXPECT_EQ(edge.rule, EdgeRule::SamePlane);
  EXPECT_FLOAT_EQ(edge.margin, 0.4f);
  EXPECT_EQ(edge.border, 5u);
}

TEST(Edges, OnTwoPlanesIsOff) {
  Pair pair(tilted(0), tilted(0));
  pair.planes = {{3, 0.4f}, {4, 0.2f}};
  EXPECT_FALSE(pair.classify().on);
  EXPECT_EQ(pair.classify().rule, EdgeRule::DifferentPlanes);
  EXPECT_FLOAT_EQ(pair.classify().margin, 0.2f);
}

TEST(Edges, PlaneAgainstNoneIsOff) {
  Pair pair(tilted(0), tilted(0));
  pair.planes[0].plane = 0;
  EXPECT_FALSE(pair.classify().on);
  EXPECT_EQ(pair.classify().rule, EdgeRule::PlaneBoundary);
}

TEST(Edges, ConvexAndConcaveByTheSignOfTheFold) {
  // Patch 1 lies at +x of patch 0. Normals leaning apart (0 to -x, 1 to +x): a roof, convex;
  // leaning together: a valley.
  const Edge roof = Pair(tilted(-20), tilted(20)).classify();
  EXPECT_TRUE(roof.on);
  EXPECT_EQ(roof.rule, EdgeRule::Convex);
  EXPECT_NEAR(roof.normal_angle, 40, 1e-3);
  EXPECT_NEAR(roof.convexity, 2 * std::sin(20 * kRadians), 1e-5);
  EXPECT_NEAR(roof.margin, roof.convexity, 1e-6);
  const Edge valley = Pair(tilted(20), tilted(-20)).classify();
  EXPECT_FALSE(valley.on);
  EXPECT_EQ(valley.rule, EdgeRule::Concave);
  EXPECT_NEAR(valley.convexity, -2 * std::sin(20 * kRadians), 1e-5);
  EXPECT_NEAR(valley.singular_angle, 90, 1e-3);  // the fold runs along y, the patches lie along x
}

TEST(Edges, NearlyFlatUpToTheTolerance) {
  const Edge below = Pair(tilted(4.9), tilted(-4.9)).classify();
  EXPECT_TRUE(below.on);
  EXPECT_EQ(below.rule, EdgeRule::NearlyFlat);
  EXPECT_NEAR(below.margin, 0.02, 1e-3);  // |9.8 - 10| / 10
  const Edge above = Pair(tilted(5.1), tilted(-5.1)).classify();
  EXPECT_FALSE(above.on);
  EXPECT_EQ(above.rule, EdgeRule::Concave);
  EXPECT_NEAR(above.margin, 0.02, 1e-3);
}

TEST(Edges, SingularBelowTheSigmoid) {
  // Normals at +-20 about y: the fold is y; the limit is 60 / (1 + exp(-0.25 (40 - 25))) = 58.6
  // degrees.
  const double limit = 60 / (1 + std::exp(-0.25 * 15));
  const auto along =
      [&](double degrees) {  // direction between the patches at this angle to the fold
        return Eigen::Vector3f(float(std::sin(degrees * kRadians)),
                               float(std::cos(degrees * kRadians)), 0);
      };
  const Edge below = Pair(tilted(-20), tilted(20), along(limit - 1)).classify();
  EXPECT_FALSE(below.on);
  EXPECT_EQ(below.rule, EdgeRule::Singular);
  EXPECT_NEAR(below.singular_limit, limit, 1e-3);
  EXPECT_NEAR(below.singular_angle, limit - 1, 1e-2);
  EXPECT_NEAR(below.margin, 1 / limit, 1e-3);
  EXPECT_EQ(Pair(tilted(-20), tilted(20), along(limit + 1)).classify().rule, EdgeRule::Convex);
  Pair off(tilted(-20), tilted(20), along(limit - 1));
  off.options.singular_angle = 0;
  EXPECT_EQ(off.classify().rule, EdgeRule::Convex);
}

TEST(Edges, StepBeyondWhatTheNormalsExplain) {
  // Parallel patches, one higher by h: the limit is 0.1 voxels = 1 mm.
  const auto raised = [&](float h) { return Pair(tilted(0), tilted(0), {1, 0, h}).classify(); };
  EXPECT_EQ(raised(0.0009f).rule, EdgeRule::Convex);  // flat counts as convex
  const Edge step = raised(0.0011f);
  EXPECT_FALSE(step.on);
  EXPECT_EQ(step.rule, EdgeRule::Step);
  EXPECT_NEAR(step.step, 0.0011, 1e-6);
  EXPECT_NEAR(step.step_limit, 0.001, 1e-6);
  EXPECT_NEAR(step.margin, 0.1, 1e-2);
}

// Three patches on a gentle roof, each adjacent to both others.
TEST(Edges, SupportByACommonNeighbour) {
  PatchGraph graph;
  graph.patches.resize(3);
  graph.patches[0].normal = tilted(-10);
  graph.patches[1].normal = tilted(10);
  graph.patches[1].centroid = {1, 0, 0};
  graph.patches[2].normal = tilted(0);
  graph.patches[2].centroid = {0.5f, 0.5f, 0.05f};
  graph.adjacency = {{0, 1, 1}, {0, 2, 1}, {1, 2, 1}};
  graph.voxel_size = 1;
  graph.patch_size = 1;
  const std::vector<PatchPlane> none(3);
  EdgeOptions strict;
  strict.extended_convexity = true;
  for (const Edge& edge : classify_edges(graph, none, strict)) {
    EXPECT_TRUE(edge.on);
    EXPECT_EQ(edge.support, 1u);
  }
  graph.adjacency.pop_back();  // without 1-2 nothing supports the others
  for (const Edge& edge : classify_edges(graph, none, strict)) {
    EXPECT_FALSE(edge.on);
    EXPECT_EQ(edge.rule, EdgeRule::NoSupport);
    EXPECT_EQ(edge.support, 0u);
  }
  for (const Edge& edge : classify_edges(graph, none, {})) EXPECT_TRUE(edge.on);
}

TEST(Edges, RulesAreCountedAndNamed) {
  std::vector<Edge> edges(5);
  edges[0].rule = edges[1].rule = EdgeRule::Convex;
  edges[2].rule = EdgeRule::Step;
  edges[3].rule = EdgeRule::SamePlane;
  edges[4].rule = EdgeRule::NoSupport;
  const auto counts = count_rules(edges);
  EXPECT_EQ(counts[static_cast<std::size_t>(EdgeRule::Convex)], 2u);
  EXPECT_EQ(counts[static_cast<std::size_t>(EdgeRule::Concave)], 0u);
  EXPECT_EQ(name(EdgeRule::SamePlane), "same_plane");
  EXPECT_EQ(name(EdgeRule::NoSupport), "no_support");
}

TEST(Edges, TheTwoSidesOfABoardAreOneThing) {
  // Top and underside, 2 cm apart: back to back. LCCP's tests would cut: a step of 2 cm, and a fold
  // whose direction is that of noise.
  Pair board(tilted(180), tilted(2), V3(0.02f, 0.001f, 0.02f));
  board.graph.patch_size = 0.05f;
  const Edge edge = board.classify();
  EXPECT_TRUE(edge.on);
  EXPECT_EQ(edge.rule, EdgeRule::Convex);
  EXPECT_LT(edge.facing, 0);
  board.options.rim_angle = 180;
  EXPECT_FALSE(board.classify().on);
}

TEST(Edges, AcrossAGapTheyAreTwo) {
  // The same two patches the other way up look at each other, a hand's breadth apart.
  Pair gap(tilted(0), tilted(180), V3(0.0f, 0, 0.08f));
  gap.graph.patch_size = 0.05f;
  const Edge edge = gap.classify();
  EXPECT_NEAR(edge.facing, 0.08, 1e-6);
  EXPECT_FALSE(edge.on);
  EXPECT_EQ(edge.rule, EdgeRule::Concave);
  gap.graph.patches[1].centroid = V3(0, 0, 0.9f * edge.step_limit);  // within a step: one thing
  EXPECT_TRUE(gap.classify().on);
}

}  // namespace
}  // namespace planescope
