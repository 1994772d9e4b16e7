// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "planescope/segments.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

struct Toy {
  PatchGraph graph;
  std::vector<Edge> edges;
  std::vector<PatchPlane> planes;
  SegmentOptions options;

  explicit Toy(std::uint32_t patches) : planes(patches) {
    graph.patches.resize(patches);
    for (Patch& patch : graph.patches) {
      patch.point_count = 10;
      patch.area = 1;
    }
    options.min_patches = 1;
  }
  void connect(std::uint32_t a, std::uint32_t b, bool on, std::uint32_t border = 1) {
    graph.adjacency.push_back({a, b, border});
    Edge edge;
    edge.first = a;
    edge.second = b;
    edge.border = border;
    edge.on = on;
    edges.push_back(edge);
  }
  SegmentSet run() const { return connect_segments(graph, edges, planes, options); }
};

TEST(Segments, ComponentsOfOnEdgesLargestFirst) {
  Toy toy(5);
  toy.connect(0, 1, true);
  toy.connect(1, 2, false);
  toy.connect(2, 3, true);
  toy.connect(3, 4, true);
  toy.planes[2].plane = toy.planes[3].plane = 7;
  const SegmentSet set = toy.run();
  EXPECT_EQ(set.patch_label, (std::vector<std::uint32_t>{2, 2, 1, 1, 1}));
  ASSERT_EQ(set.segments.size(), 2u);
  EXPECT_EQ(set.segments[0].point_count, 30u);
  EXPECT_EQ(set.segments[0].label, 1u);
  EXPECT_EQ(set.segments[0].plane, 7);  // two of its three patches
  EXPECT_EQ(set.segments[1].plane, kNone);
  EXPECT_EQ(set.segments[1].patch_count, 2u);
}

TEST(Segments, SpecksJoinTheLongestBorder) {
  Toy toy(6);
  toy.connect(0, 1, true);
  toy.connect(0, 2, false, 3);  // patch 2 alone: border 3 to {0, 1}, 5 to {3, 4, 5}
  toy.connect(2, 3, false, 2);
  toy.connect(2, 4, false, 3);
  toy.connect(3, 4, true);
  toy.connect(4, 5, true);
  toy.options.min_patches = 2;
  const SegmentSet set = toy.run();
  EXPECT_EQ(set.segments.size(), 2u);
  EXPECT_EQ(set.patch_label[2], set.patch_label[3]);
}

TEST(Segments, IsolatedSpecksStay) {
  Toy toy(3);
  toy.connect(0, 1, true);
  toy.options.min_patches = 3;
  EXPECT_EQ(toy.run().segments.size(), 2u);
}

TEST(Segments, AgreeWithFloodFillOnRandomGraphs) {
  testing::Uniform uniform(5);
  for (int trial = 0; trial < 50; ++trial) {
    const std::uint32_t count = 40;
    Toy toy(count);
    std::vector<std::vector<std::uint32_t>> on(count);
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = a + 1; b < count; ++b) {
        if (uniform() > 0.06f) continue;
        const bool is_on = uniform() < 0.6f;
        toy.connect(a, b, is_on);
        if (is_on) {
          on[a].push_back(b);
          on[b].push_back(a);
        }
      }
    }
    const SegmentSet set = toy.run();
    for (std::uint32_t start = 0; start < count; ++start) {
      std::set<std::uint32_t> reached;
      const std::function<void(std::uint32_t)> flood = [&](std::uint32_t p) {
        if (!reached.insert(p).second) return;
        for (const std::uint32_t n : on[p]) flood(n);
      };
      flood(start);
      for (std::uint32_t p = 0; p < count; ++p) {
        EXPECT_EQ(set.patch_label[p] == set.patch_label[start], reached.count(p) == 1);
      }
    }
  }
}

TEST(Segments, AChainOfAMillionPatchesDoesNotOverflow) {
  const std::uint32_t count = 1'000'000;
  Toy toy(count);
  for (std::uint32_t p = 0; p + 1 < count; ++p) toy.connect(p, p + 1, true);
  EXPECT_EQ(toy.run().segments.size(), 1u);
}

TEST(Segments, NoPatchesNoSegments) { EXPECT_TRUE(Toy(0).run().segments.empty()); }

}  // namespace
}  // namespace planescope
