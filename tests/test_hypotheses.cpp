// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "planes/energy.hpp"
#include "planes/hypotheses.hpp"
#include "planes/random.hpp"
#include "planes_fixtures.hpp"
#include "planescope/planes.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;
using V = Eigen::Vector3f;

double degrees_between(const V& a, const V& b) {
  return std::acos(std::min(1.0f, a.dot(b))) * 180 / std::acos(-1.0);
}

/// The selected hypothesis within 3 degrees and 3 cm of a plane, same side; -1 if there is none.
std::int64_t find(const PlaneSelection& found, const Eigen::Vector4f& plane) {
  for (const std::uint32_t m : found.selected) {
    const Plane& p = found.hypotheses[m].plane;
    if (degrees_between(p.normal, plane.head<3>()) < 3 && std::abs(p.distance - plane[3]) < 0.03) {
      return m;
    }
  }
  return -1;
}

TEST(Bits, CountAgainstOneByOne) {
  std::mt19937_64 random(1);
  for (const std::size_t words : {0u, 1u, 30u, 31u, 32u, 100u}) {
    Bits a(words), b(words);
    std::uint32_t in_a = 0, in_both = 0, visited = 0;
    for (std::size_t w = 0; w < words; ++w) a[w] = random(), b[w] = w % 7 == 3 ? ~0ull : random();
    for (std::size_t i = 0; i < 64 * words; ++i) {
      in_a += contains(a, i);
      in_both += contains(a, i) && contains(b, i);
    }
    for_each(a, [&](std::size_t i) { visited += contains(a, i); });
    EXPECT_EQ(count(a), in_a);
    EXPECT_EQ(visited, in_a);
    EXPECT_EQ(count_common(a, b), in_both);
    EXPECT_EQ(any_common(a, b), in_both > 0);
  }
}

TEST(PatchIndex, FindsTheInliersThatALoopFinds) {
  std::mt19937_64 random(2);
  const PatchGraph graph = testing::toy_room();
  const PatchIndex index(graph.patches);
  for (int trial = 0; trial < 200; ++trial) {
    const auto unit = [&] { return static_cast<float>(2 * uniform_unit(random) - 1); };
    InlierTest test;
    test.plane = {V(unit(), unit(), unit()).normalized(), 4 * unit()};
    test.half_width = 0.2f;
    test.gate = trial % 3 == 0 ? 0.0f : 0.8f;
    test.center = V(2 + unit(), 2 + unit(), 1);
    if (trial % 2 == 0) test.radius = 1.5f;
    const Bits found = index.inliers(test);
    for (std::size_t i = 0; i < index.size(); ++i) {
      const Patch& patch = graph.patches[index.patch(i)];
      const float r = std::abs(test.plane.signed_distance(patch.centroid));
      const float cosine = std::abs(test.plane.normal.dot(patch.normal));
      const float far = (patch.centroid - test.center).norm();
      if (std::abs(r - 0.2f) < 1e-5f || std::abs(cosine - test.gate) < 1e-5f) continue;
      EXPECT_EQ(contains(found, i), r < 0.2f && cosine >= test.gate && far <= test.radius);
    }
  }
}

TEST(PatchIndex, NeverTakesAPatchWithoutPosition) {
  PatchGraph graph = testing::toy_room();
  graph.patches[5].centroid.x() = std::nanf("");
  graph.patches[7].normal.y() = std::nanf("");
  graph.patches[9].centroid.z() = INFINITY;
  const PatchIndex index(graph.patches);
  const Bits all = index.inliers({.plane = {V::UnitZ(), 0}, .half_width = 100, .gate = 0});
  EXPECT_EQ(count(all), graph.patches.size() - 3);
  EXPECT_EQ(select_planes(graph, {}).selected.size(), 7u);
}

TEST(NormalGate, AnEmptySliceThroughFourWallsIsNoPlane) {
  PatchGraphBuilder room(0.2f, 0, 0, 1);
  room.rectangle(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2.4f));
  room.rectangle(V(4, 0, 0), V(0, 0, 2.4f), V(0, 4, 0));
  room.rectangle(V(0, 0, 0), V(0, 0, 2.4f), V(4, 0, 0));
  room.rectangle(V(0, 4, 0), V(4, 0, 0), V(0, 0, 2.4f));
  const PatchIndex index(room.finish().patches);
  InlierTest slice{.plane = {V::UnitZ(), 1.1f}, .half_width = 0.05f, .gate = 0};
  EXPECT_EQ(count(index.inliers(slice)), 80u);  // a ring of 20 patches on each wall
  slice.gate = 0.8f;
  EXPECT_EQ(count(index.inliers(slice)), 0u);
}

TEST(SupportThreshold, IsAnAreaInPatchesThatASurfaceLiesIn) {
  std::vector<Patch> patches(5);
  EXPECT_DOUBLE_EQ(support_threshold(patches, 0.5), 3);  // no areas
  // Three specks and two patches: half of the 430 square centimetres is reached in the first patch.
  const float areas[] = {0.02f, 0.001f, 0.02f, 0.001f, 0.001f};
  for (std::size_t i = 0; i < 5; ++i) patches[i].area = areas[i];
  EXPECT_NEAR(support_threshold(patches, 0.5), 25, 1e-4);
  EXPECT_DOUBLE_EQ(support_threshold(patches, 0.001), 3);
}

TEST(ToyRoom, TheSevenPlanesAndNoOtherAreSelected) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PlaneSelection found = select_planes(testing::toy_room(seed), {});
    EXPECT_EQ(found.selected.size(), 7u) << "seed " << seed;
    for (const Eigen::Vector4f& plane : testing::toy_planes()) {
      EXPECT_GE(find(found, plane), 0) << "seed " << seed << ": " << plane.transpose();
    }
    EXPECT_GT(found.hypotheses.size(), 7u) << "nothing had to be rejected";
  }
}

TEST(ToyRoom, ThePrintedEnergyHasNoPlanesAndOursHasSeven) {
  const PatchGraph graph = testing::toy_room();
  PlaneOptions options;
  options.max_hypotheses = 20;
  const double lambda = support_threshold(graph.patches, options.min_area);
  const PatchIndex index(graph.patches);
  const auto kept = propose_hypotheses(index, options, lambda).kept;
  const PairTerms pairs = pair_terms(kept, index, graph, options);
  const SelectionEnergy ours = selection_energy(kept, pairs, lambda);
  SelectionEnergy printed = ours;
  for (std::size_t m = 0; m < kept.size(); ++m) {  // eq. (4) as printed: without the - 1
    printed.unary[m] = std::exp((lambda - kept[m].support) / lambda);
  }
  const auto planes = [](const std::vector<bool>& x) {
    return std::count(x.begin(), x.end(), true);
  };
  EXPECT_EQ(planes(minimise_selection(printed, PlaneSolver::Exhaustive, 0)), 0);
  const auto optimum = minimise_selection(ours, PlaneSolver::Exhaustive, 0);
  EXPECT_EQ(planes(optimum), 7);
  EXPECT_EQ(minimise_selection(ours, PlaneSolver::LsaTrTabu, 3000), optimum);
}

TEST(ToyRoom, NumbersOfTheSelectionAddUp) {
  const PatchGraph graph = testing::toy_room();
  const PlaneOptions options;
  const PlaneSelection found = select_planes(graph, options);
  const std::vector<PlaneHypothesis>& all = found.hypotheses;
  const auto inlier = [&](const PlaneHypothesis& h, const Patch& p) {
    return std::abs(h.plane.signed_distance(p.centroid)) < 0.05f &&
           std::abs(h.plane.normal.dot(p.normal)) >= 0.8f;
  };
  const auto v = [&](const PlaneHypothesis& a, const PlaneHypothesis& b) {
    double both = 0;
    for (const Patch& p : graph.patches) both += inlier(a, p) && inlier(b, p);
    const double angle = manhattan_deviation(a.plane.normal, b.plane.normal);
    return std::pair(1 - std::exp(-angle / 10), both / std::min(a.inlier_count, b.inlier_count));
  };
  double energy = 0;
  for (std::size_t m = 0; m < all.size(); ++m) {
    std::uint32_t inliers = 0, agree = 0;
    for (const Patch& p : graph.patches) {
      inliers += inlier(all[m], p);
      agree += inlier(all[m], p) && all[m].plane.normal.dot(p.normal) > 0;
    }
    EXPECT_EQ(all[m].inlier_count, inliers);
    EXPECT_GE(2 * agree, inliers);
    EXPECT_NEAR(all[m].inlier_area, 0.04 * inliers, 1e-3);
    EXPECT_GT(all[m].inlier_count, found.lambda);
    EXPECT_DOUBLE_EQ(all[m].data_cost, data_cost(inliers, found.lambda));
    EXPECT_LE(all[m].inlier_count, all[m - (m > 0)].inlier_count);

    double flip = all[m].data_cost, worst = 0;
    std::int32_t blocker = kNone;
    for (const std::uint32_t k : found.selected) {
      if (k == m) continue;
      const auto [angle, overlap] = v(all[m], all[k]);
      flip += angle + overlap;
      if (angle + overlap > worst) worst = angle + overlap, blocker = static_cast<int>(k);
    }
    EXPECT_NEAR(all[m].flip_cost, flip, 1e-9);
    EXPECT_EQ(all[m].selected, all[m].flip_cost < 0);
    if (all[m].selected) energy += (all[m].data_cost + flip) / 2;
    EXPECT_EQ(all[m].blocked_by, all[m].selected ? kNone : blocker);
    const double blocked = all[m].blocked_angle_cost + all[m].blocked_overlap_cost;
    EXPECT_NEAR(blocked, all[m].selected ? 0 : worst, 1e-9);
  }
  EXPECT_NEAR(found.energy, energy, 1e-9);
  EXPECT_NEAR(found.lambda, 12.5, 1e-4);
}

TEST(AngleScope, TouchingSparesPlanesThatLieApart) {
  const auto ramp_selected = [](float gap, AngleScope scope) {
    PatchGraphBuilder scene(0.1f, 0.001f, 0.01f, 1);
    scene.rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0));
    scene.rectangle(V(0, 2 + gap, 0), V(2, 0, 0), V(0, 1.2f, 1.2f));
    PlaneOptions options;
    options.angle_scope = scope;
    options.normal_gate = 0.9;  // the two planes are 45 degrees apart
    options.weight_angle = 2;   // a plane gains at most 1: now the pair always loses
    return select_planes(scene.finish(), options).selected.size() == 2;
  };
  EXPECT_FALSE(ramp_selected(0.0f, AngleScope::All));
  EXPECT_FALSE(ramp_selected(2.0f, AngleScope::All));
  EXPECT_FALSE(ramp_selected(0.0f, AngleScope::Touching));
  EXPECT_TRUE(ramp_selected(2.0f, AngleScope::Touching));
}

TEST(SelectPlanes, TakesNothingOneAndManyInParallel) {
  const PlaneSelection nothing = select_planes({}, {});
  EXPECT_TRUE(nothing.hypotheses.empty() && nothing.selected.empty());
  EXPECT_EQ(nothing.energy, 0);

  PatchGraphBuilder ball(0.1f, 0, 0, 1);
  ball.sphere(V(0, 0, 0), 0.5f, 300);
  EXPECT_TRUE(select_planes(ball.finish(), {}).selected.empty());

  PatchGraphBuilder floor(0.1f, 0.001f, 0.01f, 1);
  floor.rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0));
  const PlaneSelection one = select_planes(floor.finish(), {});
  ASSERT_EQ(one.selected, std::vector<std::uint32_t>{0});
  EXPECT_EQ(one.hypotheses[0].inlier_count, 400u);

  PatchGraphBuilder shelf(0.1f, 0.001f, 0.01f, 1);
  for (int k = 0; k < 6; ++k) {
    shelf.rectangle(V(0, 0, 0.4f * static_cast<float>(k)), V(1, 0, 0), V(0, 1, 0));
  }
  EXPECT_EQ(select_planes(shelf.finish(), {}).selected.size(), 6u);
}

TEST(SelectPlanes, CurvedPatchesAloneProposeOnlyByTriples) {
  PatchGraphBuilder builder(0.1f, 0.001f, 0.01f, 1);
  builder.rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0));
  PatchGraph graph = builder.finish();
  for (Patch& patch : graph.patches) patch.curvature = 0.2f;
  PlaneOptions options;
  const PlaneSelection by_triples = select_planes(graph, options);
  EXPECT_EQ(by_triples.selected.size(), 1u);
  EXPECT_GT(by_triples.proposed, 0u);
  EXPECT_LE(by_triples.proposed, options.triples);
  options.triples = 0;
  EXPECT_EQ(select_planes(graph, options).proposed, 0u);
}

/// More patches than the sample holds: the planes and their inliers are still those of all patches.
TEST(SelectPlanes, ASampleFindsWhatAllPatchesSupport) {
  PatchGraphBuilder builder(0.04f, 0.004f, 0.05f, 1);
  builder.rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
  builder.rectangle(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2));
  builder.rectangle(V(1, 1, 0.8f), V(1, 0, 0), V(0, 0.8f, 0));
  PatchGraph graph;
  graph.patches = builder.patches();
  ASSERT_GT(graph.patches.size(), 15000u);
  const PlaneSelection found = select_planes(graph, {});
  ASSERT_EQ(found.selected.size(), 3u);
  EXPECT_GE(found.hypotheses[found.selected[0]].inlier_count, 10000u);
  const std::int64_t table = find(found, {0, 0, 1, 0.8f});
  ASSERT_GE(table, 0);
  EXPECT_GE(found.hypotheses[static_cast<std::size_t>(table)].inlier_count, 500u);
}

bool same(const PlaneSelection& a, const PlaneSelection& b) {
  const auto bytes = [](const auto& x, const auto& y) {
    return std::memcmp(&x, &y, sizeof x) == 0;
  };
  bool equal = a.selected == b.selected && bytes(a.energy, b.energy) && a.proposed == b.proposed &&
               a.hypotheses.size() == b.hypotheses.size();
  for (std::size_t m = 0; equal && m < a.hypotheses.size(); ++m) {
    const PlaneHypothesis &h = a.hypotheses[m], &k = b.hypotheses[m];
    equal = bytes(h.plane.normal, k.plane.normal) && bytes(h.plane.distance, k.plane.distance) &&
            bytes(h.flip_cost, k.flip_cost) && h.blocked_by == k.blocked_by;
  }
  return equal;
}

TEST(SelectPlanes, IsTheSameAtAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const PatchGraph graph = testing::toy_room(seed, 0.01f);
    const PlaneSelection first = select_planes(graph, {});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(same(first, select_planes(graph, {})));
  }
}

}  // namespace
}  // namespace planescope
