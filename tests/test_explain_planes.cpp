// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "planescope/error.hpp"
#include "planescope/explain_planes.hpp"
#include "planescope/synthesize.hpp"

namespace planescope {
namespace {

struct Room {
  SynthesizedScene truth;
  Options options;
  Segmentation scene;
};

/// A room whose table tops are large enough to enter selection with some of its hypotheses refused.
const Room& room() {
  static const Room kRoom = [] {
    SynthesisOptions synthesis;
    synthesis.random_seed = 5;
    synthesis.points = 60'000;
    Room made{synthesize(synthesis), {}, {}};
    made.options = Options::automatic(made.truth.cloud);
    made.options.planes.min_area = 0.4;
    made.scene = segment(made.truth.cloud, made.options);
    return made;
  }();
  return kRoom;
}

/// D + sum of V with the selected ones is what the solver says a hypothesis costs.
void expect_sum(const HypothesisReport& r) {
  double sum = r.hypothesis.data_cost;
  for (const PairCost& pair : r.pairs) sum += pair.cost();
  EXPECT_NEAR(sum, r.hypothesis.flip_cost, 1e-4) << r.index;
}

TEST(ExplainPlanes, TheTermsAddUpToTheFlipCost) {
  const Segmentation& scene = room().scene;
  PlaneExplainer explain(scene);
  std::size_t beaten = 0;
  for (std::uint32_t p = 0; p < scene.planes.size(); ++p) {
    if (scene.planes[p].role != PlaneRole::Support) continue;
    const PlaneExplanation x = explain.plane(p, {}, Flips::Skip);
    EXPECT_EQ(x.chosen.index, scene.planes[p].hypothesis);
    EXPECT_TRUE(x.chosen.hypothesis.selected);
    EXPECT_LE(x.chosen.hypothesis.flip_cost, 0);  // it pays, or it would not be there
    expect_sum(x.chosen);
    for (const HypothesisReport& r : x.beaten) {
      EXPECT_FALSE(r.hypothesis.selected);
      EXPECT_GE(r.hypothesis.flip_cost, 0);
      ASSERT_FALSE(r.pairs.empty());
      EXPECT_EQ(r.pairs.front().plane, static_cast<std::int32_t>(p));  // dearest first
      EXPECT_NEAR(r.pairs.front().angle_cost, r.hypothesis.blocked_angle_cost, 1e-6);
      EXPECT_NEAR(r.pairs.front().overlap_cost, r.hypothesis.blocked_overlap_cost, 1e-6);
      expect_sum(r);
      ++beaten;
    }
  }
  EXPECT_GT(beaten, 0u) << "nothing was refused: the test shows nothing";
}

TEST(ExplainPlanes, AnglesAreThoseOfTheNormals) {
  PlaneExplainer explain(room().scene);
  const PlaneExplanation x = explain.plane(0, {}, Flips::Skip);
  for (const HypothesisReport& r : x.beaten) {
    const PairCost& pair = r.pairs.front();
    const auto& other = room().scene.selection.hypotheses[pair.hypothesis].plane;
    const double cosine = std::abs(double(other.normal.dot(r.hypothesis.plane.normal)));
    const double angle = std::acos(std::min(1.0, cosine)) * 180 / std::acos(-1.0);
    EXPECT_NEAR(pair.angle, std::min(angle, 90 - angle), 0.05);
    EXPECT_NEAR(pair.angle_cost, 1 - std::exp(-pair.angle / room().options.planes.alpha), 1e-6);
  }
}

TEST(ExplainPlanes, WhatWouldRemoveAPlaneRemovesIt) {
  PlaneExplainer explain(room().scene);
  const auto last =
      static_cast<std::uint32_t>(count_planes(room().scene.planes, PlaneRole::Support) - 1);
  const PlaneExplanation x = explain.plane(last);
  ASSERT_FALSE(x.flips.empty());
  for (std::size_t f = 0; f < std::min<std::size_t>(3, x.flips.size()); ++f) {
    Options changed = room().options;
    for (const Setting& s : x.flips[f].settings) set_option(changed, s.option, s.to);
    const Segmentation then = segment(room().truth.cloud, changed);
    EXPECT_EQ(then.planes.size(), x.flips[f].planes);
    for (const SupportingPlane& plane : then.planes) {
      if (plane.role != PlaneRole::Support) continue;  // it may be a face now, which cuts nothing
      const bool same =
          std::abs(plane.plane.normal.dot(x.plane.plane.normal)) > 0.996f &&
          std::abs(plane.plane.signed_distance(x.plane.plane.normal * x.plane.plane.distance)) <
              0.01f &&
          plane.patch_count > 0.8 * x.plane.patch_count;
      EXPECT_FALSE(same) << x.flips[f].settings.front().option;
    }
  }
}

/// Hand-made: |n . n_p| of 0, 1 pay nothing; what a face has is counted over the patches again.
TEST(ExplainPlanes, AFaceHasMorePatchesThanItNeedsAndPaysForTheRoom) {
  const Segmentation& scene = room().scene;
  PlaneExplainer explain(scene);
  const auto supports = count_planes(scene.planes, PlaneRole::Support);
  std::size_t faces = 0;
  for (std::uint32_t p = 0; p < scene.planes.size(); ++p) {
    const SupportingPlane& face = scene.planes[p];
    if (face.role != PlaneRole::Face) continue;
    ++faces;
    const PlaneExplanation x = explain.plane(p, {}, Flips::Skip);
    EXPECT_GT(x.chosen.inliers.size(), x.lambda);
    EXPECT_LT(x.chosen.hypothesis.data_cost, 0);
    double sum = x.chosen.hypothesis.data_cost;
    for (const PairCost& pair : x.chosen.pairs) {
      const auto& plane = scene.planes[static_cast<std::size_t>(pair.plane)];
      ASSERT_EQ(plane.role, PlaneRole::Support);
      const double cosine = std::abs(double(plane.plane.normal.dot(face.plane.normal)));
      const double angle = std::acos(std::min(1.0, cosine)) * 180 / std::acos(-1.0);
      EXPECT_NEAR(pair.angle, std::min(angle, 90 - angle), 0.05);
      EXPECT_NEAR(pair.cost(),
                  4 * (1 - std::exp(-pair.angle / room().options.planes.alpha)) / double(supports),
                  1e-6);
      sum += pair.cost();
    }
    EXPECT_NEAR(sum, x.chosen.hypothesis.flip_cost, 1e-6);
    for (const std::uint32_t i : x.chosen.inliers) {
      EXPECT_EQ(scene.patch_plane[i].plane, kNone);
      EXPECT_LT(std::abs(face.plane.signed_distance(scene.graph.patches[i].centroid)),
                room().options.planes.sigma);
    }
  }
  EXPECT_GT(faces, 0u);
}

TEST(ExplainPlanes, WhatWouldRemoveAFaceRemovesIt) {
  const Segmentation& scene = room().scene;
  PlaneExplainer explain(scene);
  const auto last = static_cast<std::uint32_t>(scene.planes.size() - 1);
  ASSERT_EQ(scene.planes[last].role, PlaneRole::Face);
  const PlaneExplanation x = explain.plane(last);
  ASSERT_FALSE(x.flips.empty());
  Options changed = room().options;
  for (const Setting& s : x.flips[0].settings) set_option(changed, s.option, s.to);
  const Segmentation then = segment(room().truth.cloud, changed);
  EXPECT_EQ(then.planes.size(), x.flips[0].planes);
  // Another face may lie in nearly the same plane: there is one less of them.
  const auto alike = [&](const Segmentation& of) {
    return std::ranges::count_if(of.planes, [&](const SupportingPlane& plane) {
      return std::abs(plane.plane.normal.dot(x.plane.plane.normal)) > 0.996f &&
             std::abs(plane.plane.signed_distance(x.plane.plane.normal * x.plane.plane.distance)) <
                 0.01f;
    });
  };
  EXPECT_EQ(alike(then), alike(scene) - 1);
}

TEST(ExplainPlanes, TruthIsCountedByPoint) {
  const std::vector<std::uint32_t>& truth = room().truth.cloud.labels;
  PlaneExplainer explain(room().scene);
  const PlaneExplanation x = explain.plane(0, truth, Flips::Skip);
  std::uint64_t points = 0;
  for (const ObjectShare& share : x.truth) points += share.points;
  EXPECT_EQ(points, x.plane.point_count);
  EXPECT_GT(x.truth.front().points, points / 2);
  EXPECT_THROW(explain.plane(0, {1, 2}, Flips::Skip), Error);
  EXPECT_THROW(explain.plane(1000), Error);
}

TEST(ExplainPlanes, MissingSaysWhichAreaWouldDo) {
  // The top of a thing of about a square metre or less is no supporting plane at 3 m^2 and up.
  Options coarse = room().options;
  coarse.planes.min_area = 3;
  const Segmentation scene = segment(room().truth.cloud, coarse);
  PlaneExplainer explain(scene);
  const TruePlane* top = nullptr;
  for (const TruePlane& face : room().truth.planes) {
    const bool level = std::abs(face.plane.normal.z()) > 0.99f && face.centroid.z() > 0.3f;
    if (level && face.area > 0.5 && (top == nullptr || face.area > top->area)) top = &face;
  }
  ASSERT_NE(top, nullptr);
  const MissingExplanation x = explain.missing(top->centroid);
  ASSERT_EQ(x.patch.plane, kNone);
  ASSERT_TRUE(x.local.has_value());
  EXPECT_GT(std::abs(x.local->plane.normal.z()), 0.99f);
  EXPECT_LE(x.local->inlier_count, x.lambda);
  EXPECT_GT(x.local->data_cost, 0);  // D alone refuses it
  ASSERT_FALSE(x.flips.empty());
  bool by_area = false;
  for (const Flip& flip : x.flips) {
    Options changed = coarse;
    for (const Setting& s : flip.settings) set_option(changed, s.option, s.to);
    by_area |= flip.settings.front().option == "planes.min_area";
    EXPECT_NE(segment(room().truth.cloud, changed).patch_plane[x.patch.id].plane, kNone);
  }
  EXPECT_TRUE(by_area);
}

TEST(ExplainPlanes, WhereThereIsAPlaneItIsNamed) {
  PlaneExplainer explain(room().scene);
  const Segmentation& scene = room().scene;
  std::size_t p = 0;
  while (scene.patch_plane[p].plane == kNone) ++p;
  const MissingExplanation x = explain.missing(scene.graph.patches[p].centroid);
  EXPECT_EQ(x.patch.id, p);
  EXPECT_EQ(x.patch.plane, scene.patch_plane[p].plane);
  EXPECT_TRUE(x.flips.empty());
  ASSERT_FALSE(x.near.empty());
  EXPECT_TRUE(x.holds.front());
  EXPECT_NE(describe(x).find("so there is a plane"), std::string::npos);
}

TEST(ExplainPlanes, PeersAreNotAsked) {
  Segmentation scene;
  scene.method.name = "ransac";
  EXPECT_THROW(PlaneExplainer{scene}, Error);
}

TEST(ExplainPlanes, PlanesWithoutTheirHypothesesAreRefused) {
  Segmentation scene = room().scene;
  scene.selection.hypotheses[scene.planes[0].hypothesis].selected = false;
  EXPECT_THROW(PlaneExplainer{scene}, Error);
  scene.selection.hypotheses.clear();
  EXPECT_THROW(PlaneExplainer{scene}, Error);
}

}  // namespace
}  // namespace planescope
