// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "baselines/baselines.hpp"
#include "baselines/deep_stack.hpp"
#include "baselines/peer_input.hpp"
#include "baselines_scene.hpp"

namespace planescope {
namespace {

using namespace planescope::testing;

/// The label that most points of a true region got, and the share of the region that got it.
std::pair<std::uint32_t, double> main_label(const PointCloud& cloud,
                                            const std::vector<std::uint32_t>& found,
                                            std::uint32_t region) {
  std::map<std::uint32_t, std::size_t> count;
  std::size_t total = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (cloud.labels[i] == region) ++total, ++count[found[i]];
  std::pair<std::uint32_t, std::size_t> best{0, 0};
  for (const auto& entry : count)
    if (entry.second > best.second) best = entry;
  return {best.first, static_cast<double>(best.second) / static_cast<double>(total)};
}

void expect_three_objects(const PointCloud& cloud, const PeerResult& result) {
  ASSERT_EQ(result.point_label.size(), cloud.size());
  std::set<std::uint32_t> distinct;
  for (const std::uint32_t region : {1U, 2U, 3U}) {
    const auto [label, share] = main_label(cloud, result.point_label, region);
    EXPECT_NE(label, kNoSegment) << result.method << " region " << region;
    EXPECT_GT(share, 0.8) << result.method << " region " << region;
    distinct.insert(label);
  }
  EXPECT_EQ(distinct.size(), 3U) << result.method;
  EXPECT_EQ(main_label(cloud, result.point_label, 1).first, 1U) << "the largest segment is 1";
  std::set<std::uint32_t> used;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i])) {
      EXPECT_EQ(result.point_label[i], kNoSegment);
    }
    if (result.point_label[i] != kNoSegment) used.insert(result.point_label[i]);
  }
  EXPECT_EQ(used.size(), result.segment_count);
  EXPECT_EQ(*used.rbegin(), result.segment_count) << "labels are contiguous";
}

/// The same points as `cloud`, organised in two rows.
PointCloud organised(PointCloud cloud) {
  cloud.height = 2;
  cloud.width /= 2;
  return cloud;
}

TEST(Baselines, LccpSeparatesTwoBoxesFromTheTable) {
  const PointCloud cloud = toy_scene();
  const PeerResult result = lccp(cloud);
  expect_three_objects(cloud, result);
  EXPECT_FALSE(result.has_planes);
  ASSERT_TRUE(result.has_graph);
  EXPECT_EQ(result.edge_on.size(), result.graph.adjacency.size());
  // What PCL joins directly lies in one segment.
  std::vector<std::uint32_t> label(result.graph.patches.size(), kNoSegment);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (result.graph.point_patch[i] != kNone)
      label[static_cast<std::size_t>(result.graph.point_patch[i])] = result.point_label[i];
  std::size_t on = 0;
  for (std::size_t e = 0; e < result.edge_on.size(); ++e) {
    if (!result.edge_on[e]) continue;
    ++on;
    EXPECT_EQ(label[result.graph.adjacency[e].first], label[result.graph.adjacency[e].second]);
  }
  EXPECT_GT(on, result.edge_on.size() / 2);
}

TEST(Baselines, CpcSeparatesTwoBoxesFromTheTable) {
  const PointCloud cloud = toy_scene();
  CpcOptions options;
  options.ransac_iterations = 500;
  expect_three_objects(cloud, cpc(cloud, options));
}

TEST(Baselines, RansacFindsTheTableAndTwoClusters) {
  const PointCloud cloud = toy_scene();
  const PeerResult result = ransac(cloud);
  expect_three_objects(cloud, result);
  EXPECT_FALSE(result.has_graph);
  ASSERT_EQ(result.planes.size(), 1U);
  EXPECT_GT(result.planes[0].normal.z(), 0.9999F) << "towards the sensor above the table";
  EXPECT_NEAR(result.planes[0].distance, 0.0F, 1e-3F);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (result.point_plane[i] == 0) {
      EXPECT_LT(std::abs(cloud.positions[i].z()), 0.02F);
    }
}

TEST(Baselines, RansacAtFullResolutionLabelsEveryPointOfTheTable) {
  const PointCloud cloud = toy_scene();
  RansacOptions options;
  options.voxel_size = 0;
  const PeerResult result = ransac(cloud, options);
  expect_three_objects(cloud, result);
  EXPECT_DOUBLE_EQ(main_label(cloud, result.point_label, 1).second, 1.0);
}

TEST(Baselines, SameAnswerTwiceAndForOrganisedClouds) {
  const PointCloud cloud = toy_scene(), rows = organised(cloud);
  CpcOptions cutting;
  cutting.ransac_iterations = 200;
  cutting.min_edges = 50;
  const PeerResult once[] = {ransac(cloud), lccp(cloud), cpc(cloud, cutting)};
  // Allocations in between move PCL's graph vertices in memory; its answer must not follow them.
  std::vector<std::vector<char>> noise;
  for (std::size_t n = 1; n < 400; ++n) noise.emplace_back(n * 37 % 500);
  for (std::size_t n = 0; n < noise.size(); n += 2) noise[n] = {};
  const PeerResult twice[] = {ransac(rows), lccp(rows), cpc(rows, cutting)};
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_EQ(once[m].point_label, twice[m].point_label) << once[m].method;
    EXPECT_EQ(once[m].graph.point_patch, twice[m].graph.point_patch) << once[m].method;
    EXPECT_EQ(once[m].edge_on, twice[m].edge_on) << once[m].method;
  }
}

TEST(Baselines, RansacSeedChangesTheDrawsOnly) {
  const PointCloud cloud = toy_scene();
  RansacOptions options;
  options.random_seed = 99;
  expect_three_objects(cloud, ransac(cloud, options));
}

TEST(Baselines, CloudsWithoutAPointAreRefused) {
  PointCloud empty, blind;
  blind.positions.assign(3, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  blind.width = 3;
  for (const PointCloud& cloud : {empty, blind}) {
    EXPECT_EQ(kind_of([&] { ransac(cloud); }), Error::Kind::Input);
    EXPECT_EQ(kind_of([&] { lccp(cloud); }), Error::Kind::Input);
    EXPECT_EQ(kind_of([&] { cpc(cloud); }), Error::Kind::Input);
    EXPECT_EQ(kind_of([&] { pcl_patches(cloud, {}); }), Error::Kind::Input);
  }
}

TEST(Baselines, SenselessOptionsAndExtentsAreRefused) {
  PointCloud cloud;
  cloud.positions = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(kind_of([&] { pcl_patches(cloud, {.voxel_size = 0.1, .patch_size = 0.1}); }),
            Error::Kind::Usage);
  RansacOptions all;
  all.min_plane_share = 0;
  EXPECT_EQ(kind_of([&] { ransac(cloud, all); }), Error::Kind::Usage);
  cloud.positions[1].x() = 1e6F;
  EXPECT_EQ(kind_of([&] { lccp(cloud); }), Error::Kind::Computation);
  EXPECT_EQ(kind_of([&] { ransac(cloud); }), Error::Kind::Computation);
}

TEST(Baselines, OnePointIsNoPlane) {
  PointCloud cloud;
  cloud.positions = {{1, 2, 3}};
  cloud.width = 1;
  RansacOptions options;
  options.min_cluster_size = 1;
  const PeerResult found = ransac(cloud, options);
  EXPECT_TRUE(found.planes.empty());
  EXPECT_EQ(found.point_label, std::vector<std::uint32_t>{1});
  EXPECT_LE(lccp(cloud).segment_count, 1U);
  EXPECT_LE(cpc(cloud).segment_count, 1U);
}

TEST(Baselines, LabelsAreRankedBySize) {
  std::vector<std::uint32_t> labels{7, 0, 3, 3, 9, 7, 3};
  EXPECT_EQ(rank_labels(labels), 3U);
  EXPECT_EQ(labels, (std::vector<std::uint32_t>{2, 0, 1, 1, 3, 2, 1}));
}

int depth(int n) {
  volatile char frame[512] = {};
  return n == 0 ? frame[0] : depth(n - 1) + 1 + frame[0];
}

TEST(Baselines, DeepRecursionHasTheStackItNeeds) {
  int reached = 0;
  run_with_stack(std::size_t{128} << 20, [&] { reached = depth(100'000); });  // some 60 MB
  EXPECT_EQ(reached, 100'000);
  EXPECT_EQ(kind_of([] {
              run_with_stack(1 << 20, [] { throw Error(Error::Kind::Input, "passed on"); });
            }),
            Error::Kind::Input);
}

}  // namespace
}  // namespace planescope
