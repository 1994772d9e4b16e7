// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/stored_scene.hpp"
#include "planescope/synthesize.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;

struct Stored {
  PointCloud cloud;
  Segmentation scene;
  TemporaryFolder folder;

  explicit Stored(const Eigen::Vector3d& origin = {0, 0, 0}) {
    SynthesisOptions options;
    options.random_seed = 5;
    options.points = 40'000;
    cloud = synthesize(options).cloud;
    cloud.origin = origin;
    scene = segment(cloud, Options::automatic(cloud));
    save(scene, cloud, folder.path(), {"room.ply", "00ff"});
    save_geometry(scene, cloud, folder.path());
  }
};

void expect_same_edges(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t e = 0; e < a.size(); ++e) {
    EXPECT_EQ(std::tie(a[e].first, a[e].second, a[e].border, a[e].on, a[e].rule, a[e].support),
              std::tie(b[e].first, b[e].second, b[e].border, b[e].on, b[e].rule, b[e].support));
    EXPECT_EQ(std::tie(a[e].normal_angle, a[e].convexity, a[e].singular_angle, a[e].singular_limit,
                       a[e].step, a[e].step_limit, a[e].margin),
              std::tie(b[e].normal_angle, b[e].convexity, b[e].singular_angle, b[e].singular_limit,
                       b[e].step, b[e].step_limit, b[e].margin));
  }
}

TEST(RenderStoredScene, ComesBackToTheBit) {
  const Stored stored;
  const Segmentation& scene = stored.scene;
  const StoredScene loaded = load_scene(stored.folder.path());
  const Segmentation& back = loaded.scene;
  EXPECT_EQ(loaded.input.name, "room.ply");
  EXPECT_EQ(loaded.cloud.positions, stored.cloud.positions);
  expect_same_edges(scene.edges, back.edges);
  EXPECT_EQ(scene.graph.adjacency, back.graph.adjacency);
  EXPECT_EQ(scene.point_label, back.point_label);
  EXPECT_EQ(scene.segments.patch_label, back.segments.patch_label);
  ASSERT_EQ(scene.graph.patches.size(), back.graph.patches.size());
  for (std::size_t p = 0; p < scene.graph.patches.size(); ++p) {
    const Patch &a = scene.graph.patches[p], &b = back.graph.patches[p];
    EXPECT_EQ(a.centroid, b.centroid);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(std::tie(a.curvature, a.area, a.scale, a.point_count),
              std::tie(b.curvature, b.area, b.scale, b.point_count));
    EXPECT_EQ(scene.patch_plane[p].plane, back.patch_plane[p].plane);
    EXPECT_EQ(scene.patch_plane[p].margin, back.patch_plane[p].margin);
  }
  for (const OptionInfo& info : option_table())
    EXPECT_EQ(get_option(scene.options, info.name), get_option(back.options, info.name));
  EXPECT_EQ(scene.selection.selected, back.selection.selected);
  ASSERT_EQ(scene.selection.hypotheses.size(), back.selection.hypotheses.size());
  for (std::size_t m = 0; m < scene.selection.hypotheses.size(); ++m) {
    const PlaneHypothesis &a = scene.selection.hypotheses[m], &b = back.selection.hypotheses[m];
    EXPECT_EQ(a.plane.normal, b.plane.normal);
    EXPECT_EQ(std::tie(a.plane.distance, a.inlier_count, a.inlier_area, a.data_cost, a.selected,
                       a.flip_cost, a.blocked_by),
              std::tie(b.plane.distance, b.inlier_count, b.inlier_area, b.data_cost, b.selected,
                       b.flip_cost, b.blocked_by));
  }
}

// The stages after the patches, run again on what was stored, decide as they did.
TEST(RenderStoredScene, DecidesTheSameAgain) {
  const Stored stored;
  const Segmentation back = load_scene(stored.folder.path()).scene;
  PatchGraph grown = back.graph;  // before faces gave their patches a normal
  for (Patch& patch : grown.patches) patch.normal = patch.own_normal;
  const PlaneSelection again = select_planes(grown, back.options.planes);
  EXPECT_EQ(again.selected, stored.scene.selection.selected);
  EXPECT_EQ(again.energy, stored.scene.selection.energy);
  expect_same_edges(classify_edges(back.graph, back.patch_plane, back.options.edges),
                    stored.scene.edges);
}

TEST(RenderStoredScene, MapCoordinatesAreRounded) {
  const Stored stored({500'000, 5'000'000, 100});
  const StoredScene loaded = load_scene(stored.folder.path());
  EXPECT_EQ(loaded.cloud.origin, stored.cloud.origin);
  for (std::size_t p = 0; p < stored.scene.graph.patches.size(); ++p)
    EXPECT_LT(
        (loaded.scene.graph.patches[p].centroid - stored.scene.graph.patches[p].centroid).norm(),
        1e-6f);
}

TEST(RenderStoredScene, FilesOfAnotherSceneAreRefused) {
  const Stored stored;
  Segmentation other = stored.scene;
  Edge& edge = *std::ranges::find(other.edges, EdgeRule::Concave, &Edge::rule);
  edge.rule = EdgeRule::Step;
  save_geometry(other, stored.cloud, stored.folder.path());
  try {
    load_scene(stored.folder.path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    EXPECT_NE(std::string(error.what()).find("edges by rule `concave`"), std::string::npos);
  }
}

}  // namespace
}  // namespace planescope
