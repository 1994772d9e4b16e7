// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "planescope/evaluate.hpp"

namespace planescope {
namespace {

TruePlane face(const Eigen::Vector3f& normal, const Eigen::Vector3f& centroid, double area,
               bool structural = false) {
  TruePlane made;
  made.plane = {normal, normal.dot(centroid)};
  made.centroid = centroid;
  made.area = area;
  made.structural = structural;
  return made;
}

// A plane through a point whose normal is `degrees` off z, towards x.
Plane tilted(const Eigen::Vector3f& through, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const Eigen::Vector3f normal(static_cast<float>(std::sin(angle)), 0,
                               static_cast<float>(std::cos(angle)));
  return {normal, normal.dot(through)};
}

const Eigen::Vector3f kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

TEST(ScorePlanes, CountsFoundMissedAndInvented) {
  const std::vector<TruePlane> truth = {
      face(kZ, {0, 0, 0}, 20, true), face(kX, {-3, 0, 1}, 10, true), face(kZ, {1, 1, 0.7f}, 0.8)};
  const std::vector<Plane> found = {{-kZ, 0.02f},  // the floor, the other way round, 2 cm off
                                    {kZ, 0.71f},   // the table
                                    {kY, 1.0f}};   // invented
  const PlaneScores scores = score_planes(found, truth);
  EXPECT_EQ(scores.match, (std::vector<std::int32_t>{0, kNone, 1}));
  EXPECT_DOUBLE_EQ(scores.recall, 2.0 / 3);
  EXPECT_DOUBLE_EQ(scores.structural_recall, 0.5);
  EXPECT_DOUBLE_EQ(scores.precision, 2.0 / 3);
  EXPECT_EQ(scores.true_planes, 3u);
  EXPECT_EQ(scores.structural_planes, 2u);
  EXPECT_EQ(scores.found_planes, 3u);
  EXPECT_EQ(scores.invented, 1u);
  EXPECT_EQ(scores.repeated, 0u);
  EXPECT_NEAR(scores.mean_angle, 0, 1e-6);
  EXPECT_NEAR(scores.mean_offset, 0.015, 1e-6);
  EXPECT_NEAR(scores.max_offset, 0.02, 1e-6);
  EXPECT_NEAR(scores.manhattan_deviation, 0, 1e-6);
}

TEST(ScorePlanes, BothSidesOfEachTolerance) {
  const std::vector<TruePlane> truth = {face(kZ, {4, 0, 0}, 5, true)};
  EXPECT_EQ(score_planes(std::vector<Plane>{tilted({4, 0, 0}, 4.9)}, truth).recall, 1);
  EXPECT_EQ(score_planes(std::vector<Plane>{tilted({4, 0, 0}, 5.1)}, truth).recall, 0);
  EXPECT_EQ(score_planes(std::vector<Plane>{tilted({4, 0, 0.049f}, 0)}, truth).recall, 1);
  EXPECT_EQ(score_planes(std::vector<Plane>{tilted({4, 0, 0.051f}, 0)}, truth).recall, 0);
  // Two degrees off through the origin: 4 m away, where the face is, that is 14 cm.
  EXPECT_EQ(score_planes(std::vector<Plane>{tilted({0, 0, 0}, 2)}, truth).recall, 0);
  const PlaneScores scores = score_planes(std::vector<Plane>{tilted({4, 0, 0}, 4)}, truth);
  EXPECT_NEAR(scores.mean_angle, 4, 1e-4);
  EXPECT_NEAR(scores.max_angle, 4, 1e-4);
  EXPECT_NEAR(scores.mean_offset, 0, 1e-6);
}

TEST(ScorePlanes, FacesOfOneHeightAreOneTruePlane) {
  const std::vector<TruePlane> truth = {face(kZ, {0, 0, 0.72f}, 0.4), face(kZ, {3, 0, 0.74f}, 0.3),
                                        face(-kZ, {0, 0, 0.69f}, 0.4),
                                        face(kZ, {0, 0, 0}, 20, true)};
  const std::vector<Plane> found = {{kZ, 0.72f}, {kZ, 0.0f}, {kZ, 0.01f}};
  const PlaneScores scores = score_planes(found, truth);
  EXPECT_EQ(scores.true_planes, 2u) << "0.4 + 0.3 + 0.4 m2 at table height, and the floor";
  EXPECT_EQ(scores.recall, 1);
  EXPECT_EQ(scores.match, (std::vector<std::int32_t>{0, 0, 0, 1}));
  EXPECT_EQ(scores.precision, 1);
  EXPECT_EQ(scores.repeated, 1u) << "the floor a second time";
  EXPECT_EQ(scores.invented, 0u);
}

TEST(ScorePlanes, SmallFacesMayBeFoundButNeedNot) {
  const std::vector<TruePlane> truth = {face(kZ, {0, 0, 0}, 9, true), face(kX, {2, 0, 0}, 0.2)};
  const std::vector<Plane> floor = {{kZ, 0}}, both = {{kZ, 0}, {kX, 2}};
  EXPECT_EQ(score_planes(floor, truth).recall, 1);
  EXPECT_EQ(score_planes(both, truth).precision, 1);
  EXPECT_EQ(score_planes(floor, truth, {.min_area = 0.1}).recall, 0.5);
}

TEST(ScorePlanes, TheNearestPairIsMatchedFirst) {
  // Tables 8 cm apart in height: 0.743 lies within 5 cm of both.
  const std::vector<TruePlane> truth = {face(kZ, {0, 0, 0.70f}, 1), face(kZ, {2, 0, 0.78f}, 1)};
  const PlaneScores one = score_planes(std::vector<Plane>{{kZ, 0.743f}}, truth);
  EXPECT_EQ(one.match, (std::vector<std::int32_t>{kNone, 0}));
  const PlaneScores two = score_planes(std::vector<Plane>{{kZ, 0.743f}, {kZ, 0.775f}}, truth);
  EXPECT_EQ(two.match, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(two.recall, 1);
}

TEST(ScorePlanes, NothingFoundOrNothingTrue) {
  const std::vector<TruePlane> truth = {face(kZ, {0, 0, 0}, 9, true)};
  const PlaneScores missed = score_planes({}, truth);
  EXPECT_EQ(missed.recall, 0);
  EXPECT_EQ(missed.precision, 1);
  const PlaneScores invented = score_planes(std::vector<Plane>{{kZ, 0}}, {});
  EXPECT_EQ(invented.recall, 1);
  EXPECT_EQ(invented.precision, 0);
  EXPECT_EQ(invented.invented, 1u);
}

TEST(ScorePlanes, ManhattanDeviationIsTheMeanOverPairs) {
  // 0, 10 and 90 degrees: pairs 10 -> 10, 90 -> 0, 80 -> 10.
  const std::vector<Plane> found = {tilted({0, 0, 0}, 0), tilted({0, 0, 0}, 10),
                                    tilted({0, 0, 0}, 90)};
  EXPECT_NEAR(score_planes(found, {}).manhattan_deviation, 20.0 / 3, 1e-4);
}

}  // namespace
}  // namespace planescope
