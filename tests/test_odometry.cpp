// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/odometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "odometry/observability.hpp"
#include "planescope/error.hpp"
#include "sequence_fixtures.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

/// Frames that show nothing are taken too.
constexpr OdometryOptions kAnything{.min_share = 0.3, .min_relief = 0};
constexpr SequenceOptions kNoPoses{.poses = PoseSource::None};

/// Frames whose first depth says what they see: 1000 + k is k metres along x. Equal hundreds fit.
class FakeMatcher final : public FrameMatcher {
 public:
  void take(const Frame& frame) override { taken_ = frame.depth.values.at(0); }
  void keep() override { kept_ = taken_; }
  std::optional<FrameMatch> match(const Eigen::Isometry3d& guess) override {
    guesses.push_back(guess.translation().x());
    if (taken_ / 100 != kept_ / 100) return std::nullopt;
    FrameMatch match;
    match.motion.translation().x() = 0.1 * (int(taken_) - int(kept_));
    match.share = share;
    return match;
  }

  std::vector<double> guesses;
  double share = 0.9;

 private:
  std::uint16_t taken_ = 0, kept_ = 0;
};

Sequence make_sequence(const fs::path& folder, const std::vector<std::uint16_t>& depths) {
  testing::write_redwood(folder, static_cast<int>(depths.size()));
  for (std::size_t k = 0; k < depths.size(); ++k) {
    write_depth_image(testing::flat_depth(depths[k]),
                      folder / "depth" / (testing::number_text(static_cast<int>(k)) + ".png"));
  }
  return {folder, kNoPoses};
}

/// The x of each frame, NaN where it has no pose.
std::vector<double> places(const std::vector<std::optional<Eigen::Isometry3d>>& poses) {
  std::vector<double> all;
  for (const auto& pose : poses) all.push_back(pose ? pose->translation().x() : std::nan(""));
  return all;
}

void expect_places(const std::vector<std::optional<Eigen::Isometry3d>>& poses,
                   const std::vector<double>& expected) {
  const std::vector<double> found = places(poses);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::isnan(expected[i])) {
      EXPECT_TRUE(std::isnan(found[i])) << i;
    } else {
      EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
    }
  }
}

constexpr double kLost = std::numeric_limits<double>::quiet_NaN();

TEST(Odometry, MotionsAddUpAndGoOn) {
  const TemporaryFolder folder;
  const Sequence sequence = make_sequence(folder / "s", {1000, 1001, 1003, 1004});
  FakeMatcher matcher;
  expect_places(estimate_poses(sequence, matcher, kAnything), {0, 0.1, 0.3, 0.4});
  ASSERT_EQ(matcher.guesses.size(), 3u);  // each fits well: the second guess is not needed
  EXPECT_NEAR(matcher.guesses[1], 0.1, 1e-12);
  EXPECT_NEAR(matcher.guesses[2], 0.2, 1e-12);
  matcher.share = 0.5;  // not well: where the camera stood still is tried too
  matcher.guesses.clear();
  estimate_poses(sequence, matcher, kAnything);
  EXPECT_EQ(matcher.guesses.size(), 6u);
}

TEST(Odometry, FramesThatDoNotFitAreLost) {
  const TemporaryFolder folder;
  FakeMatcher matcher;
  // one that sees something else; later ones are put to the last that fitted
  expect_places(
      estimate_poses(make_sequence(folder / "a", {1000, 1001, 1900, 1002}), matcher, kAnything),
      {0, 0.1, kLost, 0.2});
  // the first one is the odd one
  expect_places(estimate_poses(make_sequence(folder / "b", {1900, 1000, 1001}), matcher, kAnything),
                {kLost, 0, 0.1});
  // of two places the one seen longer, after five frames' patience
  expect_places(estimate_poses(make_sequence(folder / "c", {1000, 1001, 1200, 1201, 1202, 1203,
                                                            1204, 1205, 1206, 1207, 1208}),
                               matcher, kAnything),
                {kLost, kLost, kLost, kLost, kLost, kLost, kLost, 0, 0.1, 0.2, 0.3});
}

TEST(Odometry, WhatNoCameraDoesIsNotBelieved) {
  const TemporaryFolder folder;
  FakeMatcher matcher;
  // 0.6 m at once, and then 0.5 m over two frames
  expect_places(estimate_poses(make_sequence(folder / "a", {1000, 1006, 1005}), matcher, kAnything),
                {kLost, 0, -0.1});
  expect_places(
      estimate_poses(make_sequence(folder / "b", {1000, 1001, 1007, 1009}), matcher, kAnything),
      {0, 0.1, kLost, 0.9});
  matcher.share = 0.2;
  const Sequence sequence = make_sequence(folder / "c", {1000, 1001});
  try {
    estimate_poses(sequence, matcher, kAnything);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Computation);
    EXPECT_NE(std::string(error.what()).find("of 2 frames no two in a row fit"), std::string::npos);
  }
}

TEST(Odometry, OneFrameIsTheWorld) {
  const TemporaryFolder folder;
  FakeMatcher matcher;
  expect_places(estimate_poses(make_sequence(folder / "s", {1000}), matcher, kAnything), {0});
}

Frame frame_of(const std::function<double(int, int)>& depth,
               const std::function<int(int, int)>& grey) {
  Frame frame;
  frame.depth = {160, 120, {}};
  frame.color = {160, 120, {}};
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      frame.depth.values.push_back(static_cast<std::uint16_t>(std::lround(1000 * depth(x, y))));
      const auto value = static_cast<std::uint8_t>(grey(x, y));
      frame.color.pixels.push_back({value, value, value});
    }
  }
  return frame;
}

// By hand: of a wall all normals are alike, of a corner of two they share what is orthogonal to
// both; a corner of three walls seen down its middle has a third of its normals along each.
TEST(Odometry, ObservabilityIsOfTheWeakestDirection) {
  DepthCamera camera;
  camera.lens = {.width = 160, .height = 120, .fx = 130, .fy = 130, .cx = 79.5, .cy = 59.5};
  const auto plain = [](int, int) { return 100; };
  const auto wall = [](int, int) { return 2.0; };
  EXPECT_LT(odometry::observe(frame_of(wall, plain), camera).relief, 1e-9);
  const auto two = [&](int x, int) { return 2 / (1 + std::abs(x - 79.5) / 130); };  // at 45 degrees
  EXPECT_LT(odometry::observe(frame_of(two, plain), camera).relief, 1e-3);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 1, 1).normalized();
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(axis, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto three = [&](int x, int y) {
    const Eigen::Vector3d ray((x - 79.5) / 130, (y - 59.5) / 130, 1);
    double nearest = 1e9;  // walls whose normals are the turned axes, 1 m away
    for (int k = 0; k < 3; ++k)
      nearest = std::min(nearest, 1 / std::max(1e-9, turn.col(k).dot(ray)));
    return nearest;
  };
  EXPECT_NEAR(odometry::observe(frame_of(three, plain), camera).relief, 1.0 / 3, 0.06);
  std::uint32_t state = 1;  // noise of 17 mm, as a depth camera has it at 3.5 m, is no relief
  const auto noisy = [&](int, int) {
    double sum = 0;
    for (int k = 0; k < 12; ++k) sum += (state = state * 1664525 + 1013904223) / 4294967296.0;
    return 3.5 + 0.017 * (sum - 6);
  };
  EXPECT_LT(odometry::observe(frame_of(noisy, plain), camera).relief, 0.005);
  // A wall that is painted all over, in both directions, or in stripes, or not.
  const auto painted = [](int x, int y) {
    return int(128 + 60 * std::sin(0.3 * x) + 60 * std::sin(0.3 * y));
  };
  const auto striped = [](int x, int) { return int(128 + 60 * std::sin(0.3 * x)); };
  EXPECT_GT(odometry::observe(frame_of(wall, painted), camera).texture, 0.3);
  EXPECT_LT(odometry::observe(frame_of(wall, striped), camera).texture, 1e-9);
  EXPECT_EQ(odometry::observe(frame_of(wall, plain), camera).texture, 0);
}

TEST(Odometry, FramesThatShowNothingAreLost) {
  const TemporaryFolder folder;
  FakeMatcher matcher;
  try {
    estimate_poses(make_sequence(folder / "s", {1000, 1001}), matcher);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Computation);
    EXPECT_NE(std::string(error.what()).find("none shows relief or texture"), std::string::npos);
  }
}

}  // namespace
}  // namespace planescope
