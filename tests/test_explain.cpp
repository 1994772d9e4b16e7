// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>

#include "planescope/error.hpp"
#include "planescope/explain.hpp"
#include "planescope/synthesize.hpp"

namespace planescope {
namespace {

SynthesizedScene make_room(std::uint64_t points) {
  SynthesisOptions options;
  options.random_seed = 5;
  options.points = points;
  return synthesize(options);
}

/// A scene of patches in a row, joined as `edges` say: (first, second, on, margin).
struct Link {
  std::uint32_t a, b;
  bool on;
  float margin;
};
Segmentation linked(std::size_t patches, std::vector<Link> links) {
  Segmentation scene;
  scene.graph.patches.resize(patches);
  for (std::size_t i = 0; i < patches; ++i) {
    scene.graph.patches[i].centroid = {static_cast<float>(i), 0, 0};
  }
  std::ranges::sort(links, {}, [](const Link& l) { return std::pair(l.a, l.b); });
  for (const Link& link : links) {
    Edge edge;
    edge.first = link.a;
    edge.second = link.b;
    edge.on = link.on;
    edge.rule = link.on ? EdgeRule::Convex : EdgeRule::Concave;
    edge.margin = link.margin;
    scene.edges.push_back(edge);
    scene.graph.adjacency.push_back({link.a, link.b, 1});
  }
  scene.patch_plane.resize(patches);
  scene.options.segments.min_patches = 1;
  scene.segments =
      connect_segments(scene.graph, scene.edges, scene.patch_plane, scene.options.segments);
  return scene;
}

TEST(Explain, FindsEdgesByTheirPatches) {
  const Segmentation scene = linked(4, {{0, 1, true, 1}, {1, 2, true, 1}, {0, 3, true, 1}});
  EXPECT_EQ(find_edge(scene, 1, 2), 2u);
  EXPECT_EQ(find_edge(scene, 3, 0), 1u);
  try {
    find_edge(scene, 0, 2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Usage);
    EXPECT_NE(std::string(error.what()).find("0 touches 1, 3"), std::string::npos) << error.what();
  }
  EXPECT_THROW(find_edge(scene, 0, 4), Error);
}

TEST(Explain, ListsEdgesByMarginAndByPlace) {
  const Segmentation scene =
      linked(5, {{0, 1, true, .5f}, {1, 2, true, .2f}, {2, 3, false, .1f}, {3, 4, true, .3f}});
  EXPECT_EQ(weakest_edges(scene, 3), (std::vector<std::size_t>{2, 1, 3}));
  EXPECT_EQ(weakest_edges(scene, 99).size(), 4u);
  EXPECT_EQ(edges_near(scene, {3.4f, 0, 0}, 2), (std::vector<std::size_t>{3, 2}));
  EXPECT_EQ(patch_at(scene, {3.4f, 1, 0}), 3u);
  const SegmentEdges first = edges_of_segment(scene, 1);
  EXPECT_EQ(first.inside, (std::vector<std::size_t>{1, 0}));
  EXPECT_EQ(first.border, (std::vector<std::size_t>{2}));
  EXPECT_THROW(edges_of_segment(scene, 3), Error);
  EXPECT_THROW(edges_of_segment(scene, 0), Error);
}

TEST(Explain, ChainGoesAroundTheWeakLink) {
  const Segmentation scene = linked(4, {{0, 1, true, .9f},
                                        {1, 3, true, .1f},
                                        {0, 2, true, .3f},
                                        {2, 3, true, .4f},
                                        {0, 3, false, .8f}});
  const Chain chain = chain_between(scene, 0, 3);
  EXPECT_TRUE(chain.joined);
  EXPECT_EQ(chain.patches, (std::vector<std::uint32_t>{0, 2, 3}));
  const auto weakest = deciding_edges(scene, chain);
  EXPECT_FLOAT_EQ(scene.edges[weakest.front()].margin, .3f);
}

TEST(Explain, ChainCrossesFewOffEdgesWhereNothingJoins) {
  // 0 - 1 | 2 | 3 (two OFF edges) or 1 | 3 with one.
  const Segmentation scene =
      linked(4, {{0, 1, true, 1}, {1, 2, false, .1f}, {2, 3, false, .1f}, {1, 3, false, .9f}});
  const Chain chain = chain_between(scene, 0, 3);
  EXPECT_FALSE(chain.joined);
  EXPECT_FALSE(chain.one_segment);
  EXPECT_EQ(chain.patches, (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(deciding_edges(scene, chain), (std::vector<std::size_t>{2}));
  EXPECT_THROW(chain_between(scene, 1, 1), Error);
  EXPECT_THROW(chain_between(scene, 1, 9), Error);
  EXPECT_THROW(chain_between(linked(3, {{0, 1, true, 1}}), 0, 2), Error);
}

/// The largest smallest margin over all simple chains of ON edges, by trying all of them.
float widest(const Segmentation& scene, std::uint32_t from, std::uint32_t to) {
  float best = -1;
  std::vector<bool> used(scene.graph.patches.size(), false);
  const std::function<void(std::uint32_t, float)> go = [&](std::uint32_t at, float least) {
    if (at == to) best = std::max(best, least);
    if (at == to) return;
    used[at] = true;
    for (const Edge& edge : scene.edges) {
      if (!edge.on || (edge.first != at && edge.second != at)) continue;
      const std::uint32_t next = edge.first == at ? edge.second : edge.first;
      if (!used[next]) go(next, std::min(least, edge.margin));
    }
    used[at] = false;
  };
  go(from, 1e9f);
  return best;
}

TEST(Explain, ChainIsTheWidestOfAll) {
  std::mt19937 random(3);
  const auto chance = [&] { return static_cast<float>(random() % 1000) / 1000; };
  int joined = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Link> links;
    for (std::uint32_t a = 0; a < 7; ++a)
      for (std::uint32_t b = a + 1; b < 7; ++b)
        if (chance() < 0.5f) links.push_back({a, b, chance() < 0.7f, chance()});
    const Segmentation scene = linked(7, links);
    const float best = widest(scene, 0, 6);
    if (best < 0) continue;
    ++joined;
    const Chain chain = chain_between(scene, 0, 6);
    ASSERT_TRUE(chain.joined);
    float least = 1e9f;
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const Edge& edge = scene.edges[chain.edges[i]];
      EXPECT_TRUE(edge.on);
      EXPECT_EQ(std::minmax(chain.patches[i], chain.patches[i + 1]),
                std::minmax(edge.first, edge.second));
      least = std::min(least, edge.margin);
    }
    EXPECT_FLOAT_EQ(least, best);
  }
  EXPECT_GT(joined, 100);
}

/// Runs of the whole method with changed options, each made once.
class Reruns {
 public:
  Reruns(const PointCloud& cloud, const Options& options) : cloud_(cloud), options_(options) {}
  const Segmentation& operator()(const std::vector<Setting>& settings) {
    std::string key;
    Options changed = options_;
    for (const Setting& s : settings) {
      key += s.option + s.to + " ";
      EXPECT_EQ(get_option(options_, s.option), s.from);
      set_option(changed, s.option, s.to);
    }
    const auto found = runs_.find(key);
    if (found != runs_.end()) return found->second;
    return runs_.emplace(key, segment(cloud_, changed)).first->second;
  }

 private:
  const PointCloud& cloud_;
  Options options_;
  std::map<std::string, Segmentation> runs_;
};

/// Per rule: how many edges were explained, were told what would flip them, and were flipped so by
/// a run of the whole method.
using Tally = std::map<EdgeRule, std::array<int, 2>>;

void try_flips(const SynthesizedScene& room, const Options& options, Tally& tally) {
  const Segmentation scene = segment(room.cloud, options);
  EdgeExplainer explain(scene);
  Reruns rerun(room.cloud, options);
  for (std::size_t rule = 0; rule < kEdgeRuleCount; ++rule) {
    std::vector<std::size_t> edges;
    for (std::size_t e = 0; e < scene.edges.size(); ++e)
      if (static_cast<std::size_t>(scene.edges[e].rule) == rule) edges.push_back(e);
    // The four weakest, and others from all over.
    std::ranges::stable_sort(edges, {}, [&](std::size_t e) { return scene.edges[e].margin; });
    const std::size_t step = std::max<std::size_t>(1, edges.size() / 4);
    for (std::size_t i = 0; i < edges.size(); i += i < 4 ? 1 : step) {
      const EdgeExplanation x = explain(edges[i]);
      auto& [explained, flipped] = tally[x.edge.rule];
      ++explained;
      flipped += x.flips.empty() ? 0 : 1;
      for (std::size_t f = 0; f < std::min<std::size_t>(2, x.flips.size()); ++f) {
        const Flip& flip = x.flips[f];
        const Segmentation& then = rerun(flip.settings);
        ASSERT_EQ(then.edges.size(), scene.edges.size());
        EXPECT_NE(then.edges[x.index].on, x.edge.on) << describe(x);
        EXPECT_EQ(then.edges[x.index].rule, flip.rule) << describe(x);
        EXPECT_EQ(then.planes.size(), flip.planes);
        EXPECT_EQ(then.segments.segments.size(), flip.segments);
        std::size_t on = 0, off = 0;
        for (std::size_t e = 0; e < then.edges.size(); ++e) {
          on += then.edges[e].on && !scene.edges[e].on;
          off += !then.edges[e].on && scene.edges[e].on;
        }
        EXPECT_EQ(on, flip.switched_on);
        EXPECT_EQ(off, flip.switched_off);
      }
    }
  }
}

TEST(Explain, WhatWouldFlipAnEdgeDoesFlipIt) {
  const SynthesizedScene room = make_room(40'000);
  Options options = Options::automatic(room.cloud);
  Tally tally;
  try_flips(room, options, tally);
  options.edges.extended_convexity = true;
  options.edges.smoothness_tolerance = 0;  // so that there are steps
  try_flips(room, options, tally);
  int all = 0;
  for (std::size_t rule = 0; rule < kEdgeRuleCount; ++rule) {
    const auto [explained, flipped] = tally[static_cast<EdgeRule>(rule)];
    EXPECT_GE(flipped, 3) << name(static_cast<EdgeRule>(rule)) << " of " << explained;
    all += flipped;
    RecordProperty(std::string(name(static_cast<EdgeRule>(rule))),
                   std::to_string(flipped) + " of " + std::to_string(explained));
  }
  EXPECT_GE(all, 50);
}

TEST(Explain, MeasuresStandBesideTheirThresholds) {
  const SynthesizedScene room = make_room(40'000);
  const Segmentation scene = segment(room.cloud, Options::automatic(room.cloud));
  EdgeExplainer explain(scene);
  for (std::size_t e = 0; e < scene.edges.size(); e += 7) {
    const EdgeExplanation x = explain(e, Flips::Skip);
    EXPECT_TRUE(x.flips.empty());
    EXPECT_TRUE(std::ranges::any_of(x.measures, &Measure::decided));
    bool all_hold = true, planes = false;  // the state follows from what is shown
    std::map<std::string, const Measure*> by_name;
    for (const Measure& m : x.measures) {
      by_name[m.name] = &m;
      planes |= m.decided && m.option.starts_with("planes.");
    }
    if (planes) continue;
    if (by_name.contains("facing distance")) {
      EXPECT_EQ(by_name.at("facing distance")->holds, x.edge.on) << describe(x);
      continue;
    }
    all_hold &= by_name.at("angle to the fold")->holds && by_name.at("step")->holds;
    all_hold &= by_name.at("convexity")->holds || by_name.at("angle of the normals")->holds;
    all_hold &= by_name.at("common convex neighbours")->holds;
    EXPECT_EQ(all_hold, x.edge.on) << describe(x);
  }
  EXPECT_THROW(explain(scene.edges.size()), Error);
}

TEST(Explain, PeersAreNotAsked) {
  Segmentation scene = linked(2, {{0, 1, true, 1}});
  scene.method.name = "lccp";
  EdgeExplainer explain(scene);
  EXPECT_THROW(explain(0), Error);
}

}  // namespace
}  // namespace planescope
