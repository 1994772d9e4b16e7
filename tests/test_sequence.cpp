// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/sequence.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "planescope/error.hpp"
#include "sequence_fixtures.hpp"

namespace planescope {
namespace {

namespace fs = std::filesystem;
using testing::read_bytes;
using testing::TemporaryFolder;
using testing::write_bytes;

/// The message of the Error{Kind::Input} that opening and reading everything gives.
std::string failure_of(const fs::path& folder, const SequenceOptions& options = {}) {
  try {
    const Sequence sequence(folder, options);
    for (std::size_t i = 0; i < sequence.size(); ++i) sequence.read(i);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "nothing";
}

void expect_failure(const fs::path& folder, const std::string& part) {
  const std::string message = failure_of(folder);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

void replace_in(const fs::path& file, const std::string& old, const std::string& now) {
  std::string text = read_bytes(file);
  const std::size_t at = text.find(old);
  ASSERT_NE(at, std::string::npos) << file;
  write_bytes(file, text.replace(at, old.size(), now));
}

void expect_small(const Sequence& sequence, SequenceLayout layout, double tolerance) {
  EXPECT_EQ(sequence.layout(), layout);
  EXPECT_EQ(sequence.camera_source(), "camera.txt");
  EXPECT_EQ(sequence.camera().lens.fy, 7.5);
  ASSERT_EQ(sequence.size(), 12u);
  for (int k = 0; k < 12; ++k) {
    const Frame frame = sequence.read(static_cast<std::size_t>(k));
    EXPECT_EQ(frame.info.number, static_cast<std::uint32_t>(k));
    EXPECT_DOUBLE_EQ(sequence.camera().depth(frame.depth.values[9]), 1 + k / 1000.0);
    EXPECT_EQ(frame.color.pixels.at(9), (Rgb{static_cast<std::uint8_t>(k), 1, 2}));
    const Eigen::Matrix4d difference = frame.info.pose.matrix() - testing::pose_of(k).matrix();
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), tolerance) << k;
  }
}

// The same frames in all three layouts.
TEST(Sequence, LayoutsAgree) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 12);
  testing::write_frames(folder / "f", 12);
  testing::write_tum(folder / "t", 12);
  expect_small(Sequence(folder / "r"), SequenceLayout::Redwood, 1e-12);
  expect_small(Sequence(folder / "f"), SequenceLayout::Frames, 1e-12);
  expect_small(Sequence(folder / "t"), SequenceLayout::Tum, 1e-12);
}

// Poses at 10.00 and 10.01 s, the frame at 10.004: four tenths of the way, and of the turn.
TEST(Sequence, PosesOfTumAreInterpolated) {
  const TemporaryFolder folder;
  testing::write_tum(folder / "t", 1);
  write_bytes(folder / "t/depth.txt", "10.004 depth/000000.png\n");
  write_bytes(folder / "t/groundtruth.txt",
              "10.00 0 0 0 0 0 0 1\n10.01 1 0 0 0 0 0.70710678118654752 0.70710678118654752\n");
  const Eigen::Isometry3d pose = Sequence(folder / "t").info(0).pose;
  EXPECT_NEAR(pose.translation().x(), 0.4, 1e-9);
  EXPECT_NEAR(std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)), 0.2 * std::numbers::pi, 1e-9);
}

TEST(Sequence, FramesFarFromAPoseAreLeftOut) {
  const TemporaryFolder folder;
  testing::write_tum(folder / "t", 3);
  replace_in(folder / "t/groundtruth.txt", "11.004", "11.021");
  const Sequence sequence(folder / "t");
  EXPECT_EQ(sequence.size(), 2u);
  EXPECT_EQ(sequence.unposed(), 1u);
  EXPECT_EQ(sequence.info(1).number, 2u);
}

TEST(Sequence, LostTrackLeavesFramesOut) {
  const TemporaryFolder folder;
  testing::write_frames(folder / "f", 4);
  testing::write_redwood(folder / "r", 4);
  testing::write_tum(folder / "t", 4);
  write_bytes(folder / "f/frame-000001.pose.txt",
              "-inf -inf -inf -inf\n-inf -inf -inf -inf\n"
              "-inf -inf -inf -inf\n-inf -inf -inf -inf\n");
  replace_in(folder / "r/trajectory.log", "0 0 1 5\n", "0 0 1 nan\n");
  replace_in(folder / "t/groundtruth.txt", "12.004 1 2 5", "12.004 1 nan 5");
  for (const char* name : {"f", "r", "t"}) {
    const Sequence sequence(folder / name);
    EXPECT_EQ(sequence.size(), 3u) << name;
    EXPECT_EQ(sequence.lost(), 1u) << name;
  }
}

TEST(Sequence, RangesOfFrames) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 12);
  const Sequence sequence(folder / "r", {.first = 2, .last = 9, .step = 3});
  ASSERT_EQ(sequence.size(), 3u);
  EXPECT_EQ(sequence.info(2).number, 8u);
  EXPECT_NE(failure_of(folder / "r", {.first = 12}), "nothing");
}

TEST(Sequence, NamesAreOrderedByTheirNumbers) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 12);
  for (int k = 0; k < 12; ++k) {
    for (const char* part : {"depth", "image"}) {
      fs::rename(folder / "r" / part / (testing::number_text(k) + ".png"),
                 folder / "r" / part / (std::to_string(k) + ".png"));
    }
  }
  expect_small(Sequence(folder / "r"), SequenceLayout::Redwood, 1e-12);
}

TEST(Sequence, MissingColoursAreNoError) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 3);
  fs::remove(folder / "r/image/000001.png");
  const Sequence sequence(folder / "r");
  EXPECT_FALSE(sequence.read(0).color.empty());
  EXPECT_TRUE(sequence.read(1).color.empty());
  EXPECT_TRUE(Sequence(folder / "r", {.color = false}).read(0).color.empty());
}

TEST(Sequence, WhatIsBrokenIsSaid) {
  const TemporaryFolder folder;
  expect_failure(folder / "none", "is no folder");
  fs::create_directories(folder / "empty");
  expect_failure(folder / "empty", "is no sequence");
  const auto fresh = [&]() -> fs::path {
    fs::remove_all(folder / "r");
    testing::write_redwood(folder / "r", 3);
    return folder / "r";
  };
  fs::remove(fresh() / "trajectory.log");
  expect_failure(folder / "r", "no poses");
  replace_in(fresh() / "trajectory.log", "1 1 2\n0 -1", "1 1 2\n0 up");
  expect_failure(folder / "r", "trajectory.log: line 7: word 2 is \"up\"");
  replace_in(fresh() / "trajectory.log", "1 1 2\n0 -1", "1 1 2\n0 -2");
  expect_failure(folder / "r", "line 10: the pose that ends here is no rotation");
  replace_in(fresh() / "trajectory.log", "2 2 3\n", "7 2 3\n");
  expect_failure(folder / "r", "the pose of frame 7 has no depth image: there are 3");
  write_bytes(fresh() / "trajectory.log", "0 0 1\n1 0 0 0\n");
  expect_failure(folder / "r", "ends after 1 of the 4 lines");
  write_depth_image(testing::flat_depth(1, 4, 4), fresh() / "depth/000001.png");
  expect_failure(folder / "r", "000001.png: is 4 x 4 pixels, the camera (camera.txt) 8 x 6");
  write_color_image(testing::flat_color({}, 4, 4), fresh() / "image/000001.png");
  expect_failure(folder / "r", "000001.png: is 4 x 4 pixels, its depth 8 x 6");
  const fs::path png = fresh() / "depth/000002.png";
  write_bytes(png, read_bytes(png).substr(0, 50));
  expect_failure(folder / "r", "000002.png: byte 41: not a readable PNG: the file ends too early");
  write_bytes(fresh() / "camera.txt", "640 480 525 -525 319.5 239.5\n");
  expect_failure(folder / "r", "camera.txt: a focal length is not positive");
  fs::remove_all(fresh() / "depth");
  fs::create_directories(folder / "r/depth");
  expect_failure(folder / "r", "depth: holds no PNG");
}

TEST(Sequence, WhatIsBrokenOfTumIsSaid) {
  const TemporaryFolder folder;
  const auto fresh = [&]() -> fs::path {
    fs::remove_all(folder / "t");
    testing::write_tum(folder / "t", 3);
    return folder / "t";
  };
  replace_in(fresh() / "groundtruth.txt", "11.004 1", "11.004 1 1");
  expect_failure(folder / "t", "groundtruth.txt: line 3: has 9 words");
  fs::remove(fresh() / "depth/000002.png");
  expect_failure(folder / "t", "000002.png: cannot be opened");
  write_bytes(fresh() / "groundtruth.txt", "99 0 0 0 0 0 0 1\n");
  expect_failure(folder / "t", "none of 3 frames (of 3) has depth and pose: 0 lost their track, 3");
  replace_in(fresh() / "groundtruth.txt", "0.70710678118654752", "0.9");
  expect_failure(folder / "t", "line 2: the quaternion is not of length 1");
}

// The fixture's cameras are turned by 90 degrees about z: down, their y, is -x of the world.
// Each layout without its poses: refused, or taken as it is until someone gives poses.
TEST(Sequence, PosesMayBeMissing) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 3);
  testing::write_frames(folder / "f", 3);
  testing::write_tum(folder / "t", 3);
  for (const char* name : {"r", "f", "t"}) {
    EXPECT_TRUE(Sequence(folder / name, {.poses = PoseSource::FilesIfThere}).has_poses()) << name;
    EXPECT_FALSE(Sequence(folder / name, {.poses = PoseSource::None}).has_poses()) << name;
  }
  fs::remove(folder / "r/trajectory.log");
  fs::remove(folder / "t/groundtruth.txt");
  for (const char* k : {"0", "1", "2"})
    fs::remove(folder / ("f/frame-00000" + std::string(k) + ".pose.txt"));
  for (const char* name : {"r", "f", "t"}) {
    EXPECT_NE(failure_of(folder / name), "nothing") << name;
    Sequence sequence(folder / name, {.poses = PoseSource::FilesIfThere});
    EXPECT_FALSE(sequence.has_poses());
    ASSERT_EQ(sequence.size(), 3u) << name;
    EXPECT_EQ(sequence.unposed(), 0u);
    EXPECT_EQ(sequence.layout(), Sequence(folder / name, {.poses = PoseSource::None}).layout());
    sequence.set_poses({testing::pose_of(0), std::nullopt, testing::pose_of(2)});
    EXPECT_TRUE(sequence.has_poses());
    EXPECT_TRUE(sequence.poses_are_estimated());
    ASSERT_EQ(sequence.size(), 2u);
    EXPECT_EQ(sequence.lost(), 1u);
    EXPECT_EQ(sequence.info(1).number, 2u);
    EXPECT_EQ(sequence.info(1).pose.matrix(), testing::pose_of(2).matrix());
    EXPECT_THROW(sequence.set_poses({testing::pose_of(0)}), Error);
    EXPECT_THROW(sequence.set_poses({std::nullopt, std::nullopt}), Error);
  }
}

// Written and read again by the readers of the two layouts.
TEST(Sequence, TrajectoriesAreWritten) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 12);
  testing::write_tum(folder / "t", 12);
  for (const char* name : {"r", "t"}) {
    const fs::path file = folder / name / (*name == 'r' ? "trajectory.log" : "groundtruth.txt");
    const Sequence before(folder / name);
    write_trajectory(before, folder / (std::string(name) + file.extension().string()));
    fs::rename(folder / (std::string(name) + file.extension().string()), file);
    expect_small(Sequence(folder / name), before.layout(), 1e-9);
  }
  // poses of no round numbers come back to the bit
  Sequence sequence(folder / "r", {.poses = PoseSource::None, .last = 0});
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d(0.3, -0.2, 0.9).normalized());
  const Eigen::Isometry3d pose = Eigen::Translation3d(1.0 / 3, -2.0 / 7, 1e-7) * turn;
  sequence.set_poses({pose});
  write_trajectory(sequence, folder / "r/trajectory.log");
  EXPECT_EQ(Sequence(folder / "r", {.last = 0}).info(0).pose.matrix(), pose.matrix());
  EXPECT_THROW(write_trajectory(Sequence(folder / "r"), folder / "poses.txt"), Error);  // no times
  EXPECT_THROW(write_trajectory(Sequence(folder / "r"), folder / "poses.csv"), Error);
  EXPECT_THROW(write_trajectory(Sequence(folder / "r"), folder / "none/poses.log"), Error);
}

TEST(Sequence, UpIsWhatCamerasHeldUp) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 3);
  const auto up = Sequence(folder / "r").up();
  ASSERT_TRUE(up);
  EXPECT_TRUE(up->isApprox(Eigen::Vector3f::UnitX())) << up->transpose();
}

TEST(Sequence, CamerasFromFiles) {
  const TemporaryFolder folder;
  write_bytes(folder / "c.json", R"({"width": 320, "height": 240,
    "intrinsic_matrix": [300.5, 0, 0, 0, 301.5, 0, 159.5, 119.5, 1]})");
  const CameraFile camera = read_camera_file(folder / "c.json");
  EXPECT_EQ(camera.lens.width, 320u);
  EXPECT_EQ(camera.lens.fx, 300.5);
  EXPECT_EQ(camera.lens.fy, 301.5);
  EXPECT_EQ(camera.lens.cx, 159.5);
  EXPECT_EQ(camera.lens.cy, 119.5);
  EXPECT_FALSE(camera.depth_scale);
  for (const char* bad : {"{", "{}", R"({"width": 1, "height": 1, "intrinsic_matrix": [1]})", "1 2",
                          "640 480 0 1 2 3", "640 480 nan 525 3 3", "x", "99999 480 1 1 1 1"}) {
    write_bytes(folder / "bad", bad);
    EXPECT_THROW(read_camera_file(folder / "bad"), Error) << bad;
  }
  EXPECT_EQ(named_camera("tum_fr3").fy, 539.2);
  EXPECT_THROW(named_camera("tum"), Error);
}

TEST(Sequence, CameraOfBundleFusion) {
  const TemporaryFolder folder;
  testing::write_frames(folder / "f", 1);
  fs::remove(folder / "f/camera.txt");
  write_bytes(folder / "f/info.txt",
              "m_versionNumber = 4\nm_depthWidth = 8\nm_depthHeight = 6\nm_depthShift = 2000\n"
              "m_calibrationDepthIntrinsic = 7 0 3.5 0 0 7.5 2.5 0 0 0 1 0 0 0 0 1\n");
  const Sequence sequence(folder / "f");
  EXPECT_EQ(sequence.camera_source(), "info.txt");
  EXPECT_EQ(sequence.camera().lens.cx, 3.5);
  EXPECT_EQ(sequence.camera().lens.fy, 7.5);
  EXPECT_EQ(sequence.camera().depth_scale, 2000);
}

TEST(Sequence, HashTellsFramesPosesAndCamerasApart) {
  const TemporaryFolder folder;
  testing::write_redwood(folder / "r", 3);
  const std::string hash = Sequence(folder / "r").hash();
  EXPECT_EQ(Sequence(folder / "r").hash(), hash);
  EXPECT_NE(Sequence(folder / "r", {.last = 1}).hash(), hash);
  EXPECT_NE(Sequence(folder / "r", {.depth_scale = 999}).hash(), hash);
  replace_in(folder / "r/trajectory.log", "0 0 1 4\n", "0 0 1 4.5\n");
  EXPECT_NE(Sequence(folder / "r").hash(), hash);
}

// Pixel (x, y) at depth z is ((x - cx) / fx z, (y - cy) / fy z, z).
TEST(Unproject, PixelsBecomePoints) {
  DepthCamera camera{.lens = {.width = 3, .height = 2, .fx = 2, .fy = 4, .cx = 1, .cy = 0.5}};
  camera.max_depth = 3;
  const DepthImage depth{3, 2, {1000, 2000, 0, 65535, 500, 4000}};
  const PointCloud cloud = unproject(depth, testing::flat_color({1, 2, 3}, 3, 2), camera);
  EXPECT_EQ(cloud.width, 3u);
  EXPECT_EQ(cloud.height, 2u);
  ASSERT_TRUE(cloud.sensor);
  EXPECT_TRUE(cloud.positions[0].isApprox(Eigen::Vector3f(-0.5f, -0.125f, 1)));
  EXPECT_TRUE(cloud.positions[1].isApprox(Eigen::Vector3f(0, -0.25f, 2)));
  EXPECT_TRUE(cloud.positions[4].isApprox(Eigen::Vector3f(0, 0.0625f, 0.5f)));
  EXPECT_FALSE(is_finite(cloud.positions[2]));  // no return
  EXPECT_FALSE(is_finite(cloud.positions[3]));  // no return either
  EXPECT_FALSE(is_finite(cloud.positions[5]));  // too far
  EXPECT_EQ(cloud.colors[3], (Rgb{1, 2, 3}));
  EXPECT_THROW(unproject(depth, testing::flat_color({}, 2, 2), camera), Error);
}

TEST(Sequence, LivingRoom) {
  const fs::path folder = testing::shared_data("livingroom1");
  if (folder.empty()) GTEST_SKIP() << testing::missing("livingroom1");
  const Sequence redwood(folder), tum(folder, {.layout = SequenceLayout::Tum});
  ASSERT_EQ(redwood.size(), 211u);
  ASSERT_EQ(tum.size(), 211u);
  EXPECT_EQ(redwood.camera().depth_scale, 1000);
  std::size_t colors = 0;
  for (std::size_t i = 0; i < 211; ++i) {
    colors += redwood.info(i).color.empty() ? 0 : 1;
    EXPECT_EQ(redwood.info(i).color.filename(), tum.info(i).color.filename());
    const Eigen::Matrix4d difference = redwood.info(i).pose.matrix() - tum.info(i).pose.matrix();
    EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-6) << i;
  }
  EXPECT_EQ(colors, 206u);
  EXPECT_EQ(redwood.read(100).color.width, 640u);
}

}  // namespace
}  // namespace planescope
