// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>

#include "baselines/peer_segmentation.hpp"
#include "baselines_scene.hpp"

/// \file A peer's answer in the form of ours.
namespace planescope {
namespace {

using namespace planescope::testing;

/// What holds for every segmentation, whoever made it.
void expect_consistent(const PointCloud& cloud, const Segmentation& scene) {
  ASSERT_EQ(scene.point_label.size(), cloud.size());
  ASSERT_EQ(scene.point_plane.size(), cloud.size());
  ASSERT_EQ(scene.graph.point_patch.size(), cloud.size());
  ASSERT_EQ(scene.edges.size(), scene.graph.adjacency.size());
  ASSERT_EQ(scene.patch_plane.size(), scene.graph.patches.size());
  ASSERT_EQ(scene.segments.patch_label.size(), scene.graph.patches.size());
  std::map<std::uint32_t, std::uint32_t> points;
  for (const std::uint32_t label : scene.point_label) ++points[label];
  std::uint32_t patches = 0;
  for (const Segment& segment : scene.segments.segments) {
    EXPECT_EQ(segment.point_count, points[segment.label]);
    patches += segment.patch_count;
  }
  std::uint32_t labelled = 0;
  for (const std::uint32_t label : scene.segments.patch_label) labelled += label != 0 ? 1 : 0;
  EXPECT_EQ(patches, labelled);
}

TEST(PeerSegmentation, RansacHasPlanesAndNoGraph) {
  const PointCloud cloud = toy_scene();
  const Segmentation scene = peer_segmentation("ransac", cloud, Options::tabletop(), {});
  expect_consistent(cloud, scene);
  EXPECT_EQ(scene.method.name, "ransac");
  EXPECT_TRUE(scene.method.has_planes);
  EXPECT_FALSE(scene.method.has_graph);
  EXPECT_EQ(scene.point_label, ransac(cloud).point_label);
  ASSERT_EQ(scene.planes.size(), 1U);
  // The table's 0.8 m x 0.6 m, less what two boxes of 12 cm hide.
  EXPECT_NEAR(scene.planes[0].area, 0.48 - 2 * 0.0144, 0.03);
  EXPECT_LT(scene.planes[0].rms, 0.004F);
  EXPECT_EQ(scene.segments.segments[0].plane, 0);
  EXPECT_EQ(scene.segments.segments[1].plane, kNone);
  // A box shows three faces; what is within 1 cm of the table went to its plane.
  EXPECT_NEAR(scene.segments.segments[1].area, 3 * 0.0144, 0.015);
}

TEST(PeerSegmentation, LccpHasAGraphAndNoPlanes) {
  const PointCloud cloud = toy_scene();
  const PeerResult raw = lccp(cloud);
  const Segmentation scene = peer_segmentation("lccp", cloud, Options::room(), {});
  expect_consistent(cloud, scene);
  EXPECT_FALSE(scene.method.has_planes);
  EXPECT_TRUE(scene.method.has_graph);
  EXPECT_TRUE(scene.planes.empty());
  EXPECT_EQ(scene.options.patches.voxel_size, 0.0075) << "its own scale, not that of ours";
  EXPECT_EQ(scene.point_label, raw.point_label);
  for (std::size_t e = 0; e < scene.edges.size(); ++e) {
    const Edge& edge = scene.edges[e];
    EXPECT_EQ(edge.on, raw.edge_on[e]);
    EXPECT_EQ(edge.on, edge.rule == EdgeRule::Convex || edge.rule == EdgeRule::NearlyFlat);
    if (edge.on) {
      EXPECT_EQ(scene.segments.patch_label[edge.first], scene.segments.patch_label[edge.second]);
    }
  }
}

TEST(PeerSegmentation, AnUnknownPeerIsRefused) {
  EXPECT_EQ(kind_of([] { peer_segmentation("ours", toy_scene(), {}, {}); }), Error::Kind::Usage);
}

TEST(PeerOptions, AtTableTopScaleAreTheUsualOnes) {
  const PeerOptions usual, scaled = PeerOptions::at_scale(Options::tabletop());
  for (const char* method : {"ransac", "lccp", "cpc"}) {
    EXPECT_EQ(peer_settings(scaled, method), peer_settings(usual, method)) << method;
    EXPECT_FALSE(peer_settings(usual, method).empty());
  }
  const PeerOptions room = PeerOptions::at_scale(Options::room());
  EXPECT_DOUBLE_EQ(room.lccp.patches.patch_size, 0.1);
  EXPECT_DOUBLE_EQ(room.ransac.threshold, 0.05);
  EXPECT_NEAR(room.ransac.cluster_tolerance, 0.02 * 8 / 3, 1e-12);
}

TEST(PeerOptions, EveryOneIsSetByNameAndComesBack) {
  PeerOptions options;
  for (const PeerOptionInfo& info : peer_option_table())
    set_peer_option(options, info.name, info.unit == "flag" ? "0" : "1");
  for (const char* method : {"ransac", "lccp", "cpc"}) {
    for (const auto& [name, value] : peer_settings(options, method)) {
      const bool flag =
          name.find("local") != std::string::npos || name.find("directed") != std::string::npos ||
          name.find("clean") != std::string::npos || name.find("sanity") != std::string::npos;
      EXPECT_EQ(value, flag ? 0 : 1) << name;
    }
  }
  for (const auto& [name, value] : std::map<std::string, std::string>{{"ransac.threshold", "-1"},
                                                                      {"ransac.threshold", "wide"},
                                                                      {"lccp.min_patches", "1.5"},
                                                                      {"cpc.local", "2"},
                                                                      {"cpc.nothing", "1"},
                                                                      {"cpc.min_score", "nan"}})
    EXPECT_EQ(kind_of([&] { set_peer_option(options, name, value); }), Error::Kind::Usage) << name;
}

}  // namespace
}  // namespace planescope
