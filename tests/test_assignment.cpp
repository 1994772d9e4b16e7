// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "planes/labelling.hpp"
#include "planes/random.hpp"
#include "planes_fixtures.hpp"
#include "planescope/planes.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;

/// Eq. (10) as it is written, in doubles, from the graph itself: independent of LabellingProblem.
/// Infinite where a label is not allowed.
double energy_of(const PatchGraph& graph, const std::vector<Plane>& planes,
                 const PlaneOptions& options, const Labels& labels) {
  double sum = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == kNone) {
      sum += 2;
      continue;
    }
    const Plane& plane = planes[static_cast<std::size_t>(labels[i])];
    const Patch& patch = graph.patches[i];
    const double r = std::abs(plane.normal.dot(patch.centroid) - plane.distance) / options.sigma;
    if (std::abs(plane.normal.dot(patch.normal)) < options.normal_gate || r >= 2) return INFINITY;
    sum += r;
  }
  for (const Adjacency& e : graph.adjacency) {
    if (labels[e.first] != labels[e.second]) sum += options.smoothness;
  }
  return sum;
}

/// A few patches at random distances from a few nearly parallel planes, randomly joined.
struct Tiny {
  PatchGraph graph;
  std::vector<Plane> planes;
  PlaneOptions options;
};

Tiny random_tiny(std::mt19937_64& random, std::size_t patches, std::size_t planes) {
  Tiny t;
  for (std::size_t p = 0; p < planes; ++p) {
    t.planes.push_back({Eigen::Vector3f::UnitZ(), 0.06f * static_cast<float>(p)});
  }
  for (std::size_t i = 0; i < patches; ++i) {
    Patch patch;
    patch.centroid.z() = static_cast<float>(0.3 * uniform_unit(random) - 0.05);
    if (uniform_index(random, 6) == 0) patch.normal = Eigen::Vector3f::UnitX();
    t.graph.patches.push_back(patch);
  }
  for (std::uint32_t i = 0; i < patches; ++i) {
    for (std::uint32_t j = i + 1; j < patches; ++j) {
      if (uniform_index(random, 5) < 2) t.graph.adjacency.push_back({i, j, 1});
    }
  }
  t.options.smoothness = 0.1 + uniform_unit(random);
  return t;
}

/// The least energy over all labellings.
double least_energy(const Tiny& t) {
  double least = INFINITY;
  Labels labels(t.graph.patches.size(), kNone);
  const auto last = static_cast<std::int32_t>(t.planes.size()) - 1;
  for (;;) {
    least = std::min(least, energy_of(t.graph, t.planes, t.options, labels));
    std::size_t i = 0;
    while (i < labels.size() && labels[i] == last) labels[i++] = kNone;
    if (i == labels.size()) return least;
    ++labels[i];
  }
}

double solved_energy(const Tiny& t, AssignmentSolver solver) {
  PlaneOptions options = t.options;
  options.assignment = solver;
  return energy_of(t.graph, t.planes, options, assign_planes(t.graph, t.planes, options));
}

constexpr double kRounding = 12 * 2 / kCostUnit;  // costs are rounded to 1 / 4096 a patch and edge

TEST(Expansion, IsOptimalForOnePlane) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Tiny t = random_tiny(random, 1 + uniform_index(random, 10), 1);
    EXPECT_NEAR(solved_energy(t, AssignmentSolver::Expansion), least_energy(t), kRounding);
  }
}

TEST(Expansion, IsWithinTwiceTheOptimumAndSeldomOff) {
  std::mt19937_64 random(2);
  int optimal = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Tiny t = random_tiny(random, 7, 3);
    const double least = least_energy(t), found = solved_energy(t, AssignmentSolver::Expansion);
    EXPECT_GE(found, least - kRounding);
    EXPECT_LE(found, 2 * least + kRounding);
    optimal += found < least + kRounding;
  }
  RecordProperty("optimal_of_100", optimal);
  EXPECT_GE(optimal, 95);
}

TEST(Expansion, EndsWhereNoExpansionLowersTheEnergy) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 40; ++trial) {
    const Tiny t = random_tiny(random, 8, 3);
    const Labels labels = assign_planes(t.graph, t.planes, t.options);
    const double found = energy_of(t.graph, t.planes, t.options, labels);
    for (std::int32_t alpha = kNone; alpha < 3; ++alpha) {
      for (std::uint32_t code = 0; code < 256; ++code) {
        Labels moved = labels;
        for (std::size_t i = 0; i < 8; ++i) {
          if (((code >> i) & 1) != 0) moved[i] = alpha;
        }
        EXPECT_GE(energy_of(t.graph, t.planes, t.options, moved), found - kRounding);
      }
    }
  }
}

TEST(Expansion, NeverRaisesTheEnergyOfItsStart) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const Tiny t = random_tiny(random, 60, 4);
    const LabellingProblem problem = make_labelling_problem(t.graph, t.planes, t.options);
    const Labels start = cheapest_labels(problem), icm = relax_labels(problem, start);
    const std::int64_t before = labelling_energy(problem, start);
    EXPECT_LE(labelling_energy(problem, icm), before);
    EXPECT_LE(labelling_energy(problem, expand_labels(problem, start)), before);
    EXPECT_LE(labelling_energy(problem, expand_labels(problem, icm)),
              labelling_energy(problem, icm));
  }
}

TEST(Icm, EndsWhereNoSingleChangeLowersTheEnergy) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    Tiny t = random_tiny(random, 12, 3);
    t.options.assignment = AssignmentSolver::Icm;
    const Labels labels = assign_planes(t.graph, t.planes, t.options);
    const double found = energy_of(t.graph, t.planes, t.options, labels);
    ASSERT_TRUE(std::isfinite(found));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      for (std::int32_t label = kNone; label < 3; ++label) {
        Labels other = labels;
        other[i] = label;
        EXPECT_GE(energy_of(t.graph, t.planes, t.options, other), found - kRounding);
      }
    }
  }
}

TEST(LabellingEnergy, EqualsEquationTen) {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Tiny t = random_tiny(random, 30, 4);
    const LabellingProblem problem = make_labelling_problem(t.graph, t.planes, t.options);
    const Labels labels = cheapest_labels(problem);
    const double expected = energy_of(t.graph, t.planes, t.options, labels);
    const double tolerance =
        static_cast<double>(t.graph.patches.size() + t.graph.adjacency.size()) / kCostUnit;
    EXPECT_NEAR(static_cast<double>(labelling_energy(problem, labels)) / kCostUnit, expected,
                tolerance);
  }
}

TEST(AssignPlanes, ByHand) {
  // A row of four patches over the plane z = 0 at sigma 5 cm: on it, at 1 sigma, at 3 sigma between
  // its neighbours, and turned by 90 degrees.
  PatchGraph graph;
  for (const float z : {0.0f, 0.05f, 0.15f, 0.0f}) {
    Patch patch;
    patch.centroid = {static_cast<float>(graph.patches.size()), 0, z};
    graph.patches.push_back(patch);
  }
  graph.patches[3].normal = Eigen::Vector3f::UnitX();
  graph.adjacency = {{0, 1, 1}, {1, 2, 1}, {2, 3, 1}};
  const std::vector<Plane> floor = {{Eigen::Vector3f::UnitZ(), 0}};
  EXPECT_EQ(assign_planes(graph, floor, {}), (Labels{0, 0, kNone, kNone}));
  PlaneOptions sticky;  // U: 0 + 1 + 2 + 2 + one border of w against four times 2
  sticky.smoothness = 4;
  EXPECT_EQ(assign_planes(graph, floor, sticky), (Labels{kNone, kNone, kNone, kNone}));
  sticky.smoothness = 2.9;
  EXPECT_EQ(assign_planes(graph, floor, sticky), (Labels{0, 0, kNone, kNone}));
}

TEST(AssignPlanes, TakesEmptyGraphsAndNoPlanes) {
  EXPECT_TRUE(assign_planes({}, {}, {}).empty());
  EXPECT_TRUE(assign_planes({}, {Plane{}}, {}).empty());
  PatchGraph one;
  one.patches.resize(1);
  EXPECT_EQ(assign_planes(one, {}, {}), Labels{kNone});
  EXPECT_EQ(assign_planes(one, {Plane{}}, {}), Labels{0});
}

TEST(AssignPlanes, GivesTheToyRoomsPatchesToTheirPlanes) {
  const PatchGraph graph = testing::toy_room();
  std::vector<Plane> planes;
  for (const Eigen::Vector4f& p : testing::toy_planes()) planes.push_back({p.head<3>(), p[3]});
  const Labels labels = assign_planes(graph, planes, {});
  const auto expect = [&](std::size_t begin, std::size_t end, std::int32_t label) {
    for (std::size_t i = begin; i < end; ++i) EXPECT_EQ(labels[i], label) << "patch " << i;
  };
  expect(0, 400, 0);  // in the order in which toy_room() makes them
  expect(400, 640, 1);
  expect(640, 880, 2);
  expect(880, 1120, 3);
  expect(1120, 1360, 4);
  expect(1360, 1402, 5);
  expect(1402, 1456, 6);
}

TEST(AssignPlanes, IsTheSameAtAnyNumberOfThreads) {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 50; ++trial) {
    const Tiny t = random_tiny(random, 150, 5);
    const Labels first = assign_planes(t.graph, t.planes, t.options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(assign_planes(t.graph, t.planes, t.options), first);
  }
}

}  // namespace
}  // namespace planescope
