// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "edge_classes.hpp"
#include "fixtures.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/explain.hpp"
#include "planescope/graph_picture.hpp"
#include "planescope/io.hpp"
#include "planescope/synthesize.hpp"
#include "planescope/truth_errors.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;

/// A scene in a result folder.
struct Stored {
  PointCloud cloud;
  Segmentation scene;
  TemporaryFolder folder;
  nlohmann::json json;

  Stored(PointCloud points, const Options& options) : cloud(std::move(points)) {
    scene = segment(cloud, options);
    save(scene, cloud, folder.path());
    save_geometry(scene, cloud, folder.path());
    std::ifstream(folder / "result.json") >> json;
  }
};

Stored room(std::uint64_t seed, bool extended = false) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.points = 40'000;
  PointCloud cloud = synthesize(options).cloud;
  Options engine = Options::automatic(cloud);
  engine.edges.extended_convexity = extended;
  return {std::move(cloud), engine};
}

RenderOptions small() {
  RenderOptions options;
  options.size = {480, 320};
  options.supersample = 1;
  return options;
}

void expect_counts_of_json(const Stored& stored) {
  const auto& edges = stored.json["edges"];
  const auto png = stored.folder / "graph.png";
  const GraphPicture rules =
      render_graph(stored.folder.path(), small(), {.color = EdgeColor::Rule, .only = {}}, png);
  ASSERT_EQ(rules.edges.size(), kEdgeRuleCount);
  for (const LegendCount& line : rules.edges)
    EXPECT_EQ(line.count, edges["by_rule"][line.name].get<std::size_t>()) << line.name;
  const GraphPicture states = render_graph(stored.folder.path(), small(), {}, png);
  for (const LegendCount& line : states.edges)
    EXPECT_EQ(line.count, edges[line.name].get<std::size_t>()) << line.name;
  const GraphPicture margins =
      render_graph(stored.folder.path(), small(), {.color = EdgeColor::Margin, .only = {}}, png);
  std::size_t all = 0;
  for (const LegendCount& line : margins.edges) all += line.count;
  EXPECT_EQ(all, edges["count"].get<std::size_t>());
  EXPECT_EQ(margins.edges.front().count,
            static_cast<std::size_t>(std::ranges::count_if(
                stored.scene.edges, [](const Edge& e) { return e.margin < 0.05f; })));
}

TEST(RenderGraph, LegendCountsAreThoseOfTheJson) {
  for (const std::uint64_t seed : {1, 5}) expect_counts_of_json(room(seed));
  expect_counts_of_json(room(3, true));
}

TEST(RenderGraph, LegendCountsOfRealViewsAreThoseOfTheJson) {
  for (const char* name : {"mosd_learn/learn0.pcd", "mosd_learn/learn12.pcd",
                           "pcl/milk_cartoon_all_small_clorox.pcd"}) {
    const auto file = testing::shared_data(name);
    if (file.empty()) GTEST_SKIP() << testing::missing(name);
    expect_counts_of_json(Stored(read_cloud(file), Options::tabletop()));
  }
}

TEST(RenderGraph, FilterKeepsWhatItSays) {
  const Stored stored = room(5);
  const auto count = [&](const std::string& text) {
    GraphOptions graph{.color = EdgeColor::Rule, .only = parse_edge_filter(text)};
    std::size_t all = 0;
    for (const LegendCount& line :
         render_graph(stored.folder.path(), small(), graph, stored.folder / "a.png").edges)
      all += line.count;
    return all;
  };
  const auto wanted = [&](const auto& test) {
    return static_cast<std::size_t>(std::ranges::count_if(stored.scene.edges, test));
  };
  EXPECT_EQ(count("off"), wanted([](const Edge& e) { return !e.on; }));
  EXPECT_EQ(count("on"), wanted([](const Edge& e) { return e.on; }));
  EXPECT_EQ(count("rule=concave"),
            wanted([](const Edge& e) { return e.rule == EdgeRule::Concave; }));
  EXPECT_EQ(count("off,margin<0.1"),
            wanted([](const Edge& e) { return !e.on && e.margin < 0.1f; }));
  for (const char* bad :
       {"", "of", "rule=", "rule=bent", "margin<", "margin<x", "margin<-1", "on,,off"})
    EXPECT_THROW(parse_edge_filter(bad), Error) << bad;
}

TEST(RenderGraph, ErrorsAreCountedAsTheTruthSays) {
  const Stored stored = room(5);
  RenderOptions options = small();
  options.truth = stored.cloud.labels;
  const auto png = stored.folder / "truth.png";
  const GraphPicture picture =
      render_graph(stored.folder.path(), options, {.color = EdgeColor::Truth, .only = {}}, png);
  const auto errors = judge_edges(stored.scene.edges,
                                  patch_truth(stored.scene.graph.point_patch, stored.cloud.labels,
                                              stored.scene.graph.patches.size()));
  const ErrorSummary summary = summarise_errors(stored.scene, errors, stored.cloud.labels);
  ASSERT_EQ(picture.edges.size(), kEdgeErrorCount);
  for (std::size_t i = 0; i < kEdgeErrorCount; ++i)
    EXPECT_EQ(picture.edges[i].count, summary.edges[i]) << picture.edges[i].name;
  ASSERT_EQ(picture.points.size(), kPointErrorCount);
  for (std::size_t i = 0; i < kPointErrorCount; ++i)
    EXPECT_EQ(picture.points[i].count, summary.points[i]) << picture.points[i].name;
  // The PNG says the same.
  const std::string bytes = testing::read_bytes(png);
  EXPECT_NE(bytes.find("\"merged\":" + std::to_string(picture.edges[1].count)), std::string::npos);
  EXPECT_THROW(
      render_graph(stored.folder.path(), small(), {.color = EdgeColor::Truth, .only = {}}, png),
      Error);
  options.truth.pop_back();
  EXPECT_THROW(
      render_graph(stored.folder.path(), options, {.color = EdgeColor::Truth, .only = {}}, png),
      Error);
}

TEST(RenderGraph, KindsLookDifferent) {
  const Stored stored = room(5);
  const draw::SceneData scene = draw::scene_data(stored.folder.path());
  const std::vector<std::uint32_t> truth(scene.result.patch_count, 1);
  for (const EdgeColor color :
       {EdgeColor::State, EdgeColor::Rule, EdgeColor::Margin, EdgeColor::Truth}) {
    const auto kinds = draw::classify(scene, {.color = color, .only = {}}, truth).kinds;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      for (std::size_t k = i + 1; k < kinds.size(); ++k) {
        const auto a = draw::to_oklab(kinds[i].color), b = draw::to_oklab(kinds[k].color);
        EXPECT_GT((a - b).norm(), 0.08) << kinds[i].name << ", " << kinds[k].name;
      }
  }
}

TEST(RenderGraph, SameOptionsSameBytes) {
  const Stored stored = room(1);
  const GraphOptions graph{.color = EdgeColor::Rule, .only = {}};
  render_graph(stored.folder.path(), small(), graph, stored.folder / "a.png");
  render_graph(stored.folder.path(), small(), graph, stored.folder / "b.png");
  EXPECT_EQ(testing::read_bytes(stored.folder / "a.png"),
            testing::read_bytes(stored.folder / "b.png"));
}

}  // namespace
}  // namespace planescope
