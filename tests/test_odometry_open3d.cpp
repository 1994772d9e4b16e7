// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/odometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <string>

#include "planescope/error.hpp"
#include "sequence_fixtures.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;
using testing::write_bytes;

/// A program that a test writes: a shell script. What it is told goes nowhere.
fs::path write_script(const fs::path& file, const std::string& text) {
  write_bytes(file, "#!/bin/sh\n" + text + "\n");
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

void expect_broken(const fs::path& program, double patience, const std::string& part) {
  try {
    start_open3d_matcher(program, {}, patience);
    FAIL() << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Computation);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Odometry, AProgramThatDoesNotWorkIsAnError) {
  const TemporaryFolder folder;
  expect_broken(folder / "none", 10, "cannot be started");
  expect_broken(write_script(folder / "ends", "exit 7"), 10,
                "has ended with exit code 7, at its start");
  expect_broken(write_script(folder / "dies", "kill -SEGV $$"), 10, "has ended by signal 11");
  expect_broken(write_script(folder / "babbles", "yes 1 >&0"), 10, "answers with nonsense");
  const auto start = std::chrono::steady_clock::now();
  expect_broken(write_script(folder / "hangs", "exec sleep 60"), 0.2,
                "gives no answer, at its start");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

#ifdef PLANESCOPE_ODOMETRY_PROGRAM

/// How far a camera at `from` sees along `ray`: into a corner of a room, with a ball in it.
double look(const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  double nearest = 1e9;
  const Eigen::Vector3d walls(1.5, 1, 2.5);  // at x, y, z; the others are behind the camera
  for (int axis = 0; axis < 3; ++axis) {
    if (ray[axis] > 1e-9) nearest = std::min(nearest, (walls[axis] - from[axis]) / ray[axis]);
  }
  const Eigen::Vector3d to = Eigen::Vector3d(0.2, 0.1, 1.8) - from;
  const double along = to.dot(ray) / ray.squaredNorm();
  const double off = 0.16 - (to - along * ray).squaredNorm();  // 0.4 m in radius
  return off < 0 ? nearest : std::min(nearest, along - std::sqrt(off) / ray.norm());
}

Eigen::Isometry3d camera_at(int frame) {
  return Eigen::Translation3d(-0.4 + 0.03 * frame, 0.01 * frame, 0.02 * frame) *
         Eigen::AngleAxisd(0.3 - 0.02 * frame, Eigen::Vector3d(0.1, 1, 0.2).normalized());
}

/// What the camera sees of it: 160 x 120, walls with a pattern.
void write_room(const fs::path& folder, int frames) {
  testing::write_redwood(folder, frames);
  write_bytes(folder / "camera.txt", "160 120 130 130 79.5 59.5 5000\n");
  for (int k = 0; k < frames; ++k) {
    DepthImage depth{160, 120, {}};
    ColorImage color{160, 120, {}};
    const Eigen::Isometry3d pose = camera_at(k);
    for (int pixel = 0; pixel < 160 * 120; ++pixel) {
      const Eigen::Vector3d ray((pixel % 160 - 79.5) / 130, (pixel / 160 - 59.5) / 130, 1);
      const Eigen::Vector3d turned = pose.linear() * ray;
      const double z = look(pose.translation(), turned);
      const Eigen::Vector3d at = pose.translation() + z * turned;
      depth.values.push_back(static_cast<std::uint16_t>(std::lround(std::min(z, 13.0) * 5000)));
      const double pattern = std::sin(9 * at.x()) + std::sin(8 * at.y()) + std::sin(7 * at.z());
      const auto grey = static_cast<std::uint8_t>(128 + 40 * pattern);
      color.pixels.push_back({grey, grey, grey});
    }
    const std::string name = testing::number_text(k) + ".png";
    write_depth_image(depth, folder / "depth" / name);
    write_color_image(color, folder / "image" / name);
  }
}

/// How far estimated poses are from the true ones, once the first camera is in its place.
struct Deviation {
  double metres = 0, degrees = 0;  // worst of all frames
  std::size_t posed = 0;

  void add(const Eigen::Isometry3d& estimated, const Eigen::Isometry3d& truth) {
    const Eigen::Isometry3d off = estimated.inverse() * truth;
    const Eigen::AngleAxisd turn(off.linear());
    metres = std::max(metres, off.translation().norm());
    degrees = std::max(degrees, turn.angle() * 180 / std::numbers::pi);
    ++posed;
  }
};

std::vector<std::optional<Eigen::Isometry3d>> estimate(const fs::path& folder, std::uint32_t last,
                                                       bool color) {
  const Sequence sequence(folder, {.color = color, .poses = PoseSource::None, .last = last});
  const auto matcher = start_open3d_matcher(PLANESCOPE_ODOMETRY_PROGRAM, sequence.camera());
  return estimate_poses(sequence, *matcher);
}

TEST(Odometry, FindsTheCamera) {
  const TemporaryFolder folder;
  write_room(folder / "room", 8);
  for (const bool color : {true, false}) {
    const auto poses = estimate(folder / "room", 99, color);
    Deviation worst;
    for (int k = 0; k < 8; ++k) {
      const auto& pose = poses[static_cast<std::size_t>(k)];
      if (pose) worst.add(camera_at(0) * *pose, camera_at(k));
    }
    EXPECT_EQ(worst.posed, 8u) << color;
    EXPECT_LT(worst.metres, 0.01) << color;  // of 0.26 m
    EXPECT_LT(worst.degrees, 0.3) << color;  // of 8
  }
}

TEST(Odometry, SameBitsEachTime) {
  const TemporaryFolder folder;
  write_room(folder / "room", 4);
  const auto first = estimate(folder / "room", 99, true),
             again = estimate(folder / "room", 99, true);
  for (std::size_t k = 0; k < 4; ++k) {
    ASSERT_TRUE(first[k] && again[k]);
    EXPECT_EQ(first[k]->matrix(), again[k]->matrix());
  }
}

// Between a frame with colour and one without, and where the colours are black, depth decides.
TEST(Odometry, BlackAndMissingColours) {
  const TemporaryFolder folder;
  write_room(folder / "room", 4);
  write_color_image(testing::flat_color({0, 0, 0}, 160, 120), folder / "room/image/000001.png");
  fs::remove(folder / "room/image/000002.png");
  const auto poses = estimate(folder / "room", 99, true);
  Deviation worst;
  for (int k = 0; k < 4; ++k) {
    const auto& pose = poses[static_cast<std::size_t>(k)];
    if (pose) worst.add(camera_at(0) * *pose, camera_at(k));
  }
  EXPECT_EQ(worst.posed, 4u);
  EXPECT_LT(worst.metres, 0.005);
}

TEST(Odometry, FramesWithoutAReturnAreLost) {
  const TemporaryFolder folder;
  write_room(folder / "room", 4);
  write_depth_image(testing::flat_depth(0, 160, 120), folder / "room/depth/000001.png");
  const auto poses = estimate(folder / "room", 99, true);
  EXPECT_FALSE(poses[1]);
  EXPECT_TRUE(poses[0] && poses[2] && poses[3]);
}

// The file's poses are an estimate too.
TEST(Odometry, LivingRoom) {
  const fs::path folder = testing::shared_data("livingroom1");
  if (folder.empty()) GTEST_SKIP() << testing::missing("livingroom1");
  const Sequence truth(folder);
  const auto poses = estimate(folder, 20, true);
  Deviation worst;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (poses[k]) worst.add(truth.info(0).pose * *poses[k], truth.info(k).pose);
  }
  EXPECT_EQ(worst.posed, 21u);
  EXPECT_LT(worst.metres, 0.02);
  EXPECT_LT(worst.degrees, 1);
}

#endif

}  // namespace
}  // namespace planescope
