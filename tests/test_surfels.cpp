// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "fixtures.hpp"
#include "io_bytes.hpp"
#include "planescope/io.hpp"
#include "planescope/options.hpp"
#include "planescope/patches.hpp"
#include "toy_clouds.hpp"

/// \file Surfel maps: read, thinned out by confidence, and what radii do.
namespace planescope {
namespace {

using testing::little;
using testing::ply_header;
using testing::read;
using testing::refusal;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// As ElasticFusion writes it: colours before normals, the radius last, no confidence.
TEST(Surfels, ElasticFusionsLayout) {
  const PointCloud cloud =
      read(ply_header("binary_little_endian",
                      "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
                      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                      "property float nx\nproperty float ny\nproperty float nz\n"
                      "property float radius\n") +
           little(1.F, 2.F, 3.F, std::uint8_t{9}, std::uint8_t{8}, std::uint8_t{7}, 0.F, 0.F, -1.F,
                  0.004F) +
           little(4.F, 5.F, 6.F, std::uint8_t{3}, std::uint8_t{2}, std::uint8_t{1}, 0.F, 1.F, 0.F,
                  0.012F));
  EXPECT_EQ(cloud.radii, (std::vector<float>{0.004F, 0.012F}));
  EXPECT_FALSE(cloud.has_confidences());
  EXPECT_EQ(cloud.normals[1], Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(cloud.colors[0], (Rgb{9, 8, 7}));
}

TEST(Surfels, WhatIsNoRadiusOrConfidenceIsUnknown) {
  const PointCloud cloud =
      read(ply_header("ascii",
                      "element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                      "property double radius\nproperty float confidence\n") +
           "0 0 0 0.5 3\n0 0 1 0 -2\n0 0 2 -0.01 nan\n0 0 3 nan inf\n0 0 4 inf 1e30\n"
           "0 0 5 1e300 0\n");
  EXPECT_EQ(cloud.radii[0], 0.5F);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_TRUE(std::isnan(cloud.radii[i])) << i;
  EXPECT_EQ(cloud.confidences[1], -2);
  EXPECT_TRUE(std::isnan(cloud.confidences[2]));
  EXPECT_TRUE(std::isnan(cloud.confidences[3]));
  EXPECT_EQ(cloud.confidences[4], 1e30F);
}

TEST(Surfels, WholeNumbersAreConfidencesTooListsAreNot) {
  const auto file = [](const std::string& property, const std::string& row) {
    return ply_header("ascii",
                      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n" +
                          property + "\n") +
           "1 2 3 " + row + "\n";
  };
  EXPECT_EQ(read(file("property uchar confidence", "200")).confidences.at(0), 200);
  EXPECT_NE(refusal(file("property list uchar float radius", "1 0.5")).find("the field radius"),
            std::string::npos);
  EXPECT_NE(refusal(file("property float radius\nproperty float radius", "1 1"))
                .find("radius is declared twice"),
            std::string::npos);
}

TEST(Surfels, AreWrittenAndReadBack) {
  PointCloud cloud;
  cloud.positions = {{1, 2, 3}, {4, 5, 6}};
  cloud.normals = {{0, 0, 1}, {0, 1, 0}};
  cloud.radii = {0.01F, kNan};
  cloud.confidences = {12.5F, -1};
  cloud.width = 2;
  const testing::TemporaryFolder folder;
  for (const char* name : {"a.ply", "a.pcd"}) {
    for (const auto encoding : {CloudEncoding::Ascii, CloudEncoding::Binary}) {
      write_cloud(cloud, folder / name, encoding);
      const PointCloud back = read_cloud(folder / name);
      EXPECT_EQ(back.radii[0], 0.01F);
      EXPECT_TRUE(std::isnan(back.radii[1]));
      EXPECT_EQ(back.confidences, cloud.confidences);
    }
  }
  cloud.radii.pop_back();
  EXPECT_THROW(write_cloud(cloud, folder / "b.ply"), Error);
}

TEST(Surfels, TheUncertainAreLeftOutInPlace) {
  PointCloud cloud;
  cloud.positions = {{0, 0, 0}, {1, 0, 0}, {kNan, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  cloud.confidences = {2, 10, 0, kNan, 9.999F};
  const CertainCloud certain = leave_out_uncertain(cloud, 10);
  EXPECT_EQ(certain.left_out, 3U);  // not the one that was no point before
  ASSERT_EQ(certain.cloud.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(is_finite(certain.cloud.positions[i]), i == 1);
  EXPECT_EQ(leave_out_uncertain(cloud, -1e30).left_out, 1U);  // unknown is never enough
  const auto says = [&](double least, const char* words) {
    try {
      leave_out_uncertain(cloud, least);
    } catch (const Error& error) {
      return error.kind() == Error::Kind::Input &&
             std::string(error.what()).find(words) != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(says(11, "the highest is 10"));
  cloud.confidences.assign(5, kNan);
  EXPECT_TRUE(says(0, "none has any"));
  cloud.confidences.clear();
  EXPECT_TRUE(says(0, "no confidences"));
}

// A square metre of surfels; three of four are small and say down, the fourth is large and says up.
PointCloud make_disagreeing_surfels() {
  PointCloud cloud;
  testing::Uniform uniform(4);
  testing::add_rectangle(cloud, uniform, 8000, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.normals.emplace_back(0.F, 0.F, i % 4 == 0 ? 1.F : -1.F);
    cloud.radii.push_back(i % 4 == 0 ? 0.03F : 0.005F);
  }
  return cloud;
}

TEST(Surfels, TurnPatchesByTheAreaOfTheirDiscs) {
  PointCloud cloud = make_disagreeing_surfels();
  const PatchOptions options{.voxel_size = 0.03, .patch_size = 0.2};
  for (const Patch& patch : make_patches(cloud, options).patches) EXPECT_GT(patch.normal.z(), 0.9F);
  cloud.radii.assign(cloud.size(), kNan);  // unknown: each counts the same
  for (const Patch& patch : make_patches(cloud, options).patches)
    EXPECT_LT(patch.normal.z(), -0.9F);
}

TEST(Surfels, VoxelsAreNoFinerThanTheirRadius) {
  PointCloud cloud = testing::make_box_room(4000);  // 15.8 mm apart
  const double plain = measure_scale(cloud).connected_voxel;
  cloud.radii.assign(cloud.size(), 0.03F);
  cloud.radii[7] = kNan;
  EXPECT_NEAR(measure_scale(cloud).connected_voxel, 0.03, 1e-6);
  cloud.radii.assign(cloud.size(), 0.005F);  // finer than the spacing
  EXPECT_EQ(measure_scale(cloud).connected_voxel, plain);
  cloud.radii.assign(cloud.size(), 30.F);  // millimetres
  EXPECT_EQ(measure_scale(cloud).connected_voxel, plain);
}

}  // namespace
}  // namespace planescope
