// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "patches/creases.hpp"

namespace planescope {
namespace {

using V = Eigen::Vector3f;

// A floor about the origin and a wall that stands on it at x = 0.1, discs of radius 0.1 m. All
// points start on the floor but for the last, on the wall.
struct Crease {
  PatchGraph graph;
  PointCloud cloud;

  explicit Crease(const std::vector<V>& points) {
    graph.patches.resize(2);
    graph.patches[0].area = graph.patches[1].area = 0.0314f;
    graph.patches[1].normal = V(-1, 0, 0);
    graph.patches[1].centroid = V(0.1f, 0, 0.1f);
    graph.adjacency = {{0, 1, 3}};
    cloud.positions = points;
    graph.point_patch.assign(points.size(), 0);
    graph.point_patch.back() = 1;
    graph.patches[0].point_count = static_cast<std::uint32_t>(points.size() - 1);
    graph.patches[1].point_count = 1;
  }

  const std::vector<std::int32_t>& cut() {
    cut_at_creases(cloud, graph);
    return graph.point_patch;
  }
};

TEST(Creases, GoToTheSurfaceThatTheyLieNearestTo) {
  // By hand, 0.9 for the patch that has the point, 0.3 for what lies beyond a rim:
  // (0.09, 0, 0.05): floor 0.9 * 0.05, wall 0.01: moves. (0.05, 0, 0.001): stays.
  // (0.09, 0, 0.011): floor 0.0099, wall 0.01: a near tie stays.
  // (0.02, 0, 0): floor 0, wall 0.9 * 0.08: moves to the floor.
  // (0.1, 0.5, 0.1): floor 0.9 * (0.1 + 0.3 * 0.41), wall 0.3 * 0.4: moves.
  Crease crease({V(0.09f, 0, 0.05f), V(0.05f, 0, 0.001f), V(0.09f, 0, 0.011f), V(0.1f, 0.5f, 0.1f),
                 V(0.1f, 0, 0.1f), V(0.02f, 0, 0)});
  EXPECT_EQ(crease.cut(), (std::vector<std::int32_t>{1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(crease.graph.patches[0].point_count, 3u);
  EXPECT_EQ(crease.graph.patches[1].point_count, 3u);
}

TEST(Creases, WithoutACreaseNothingMoves) {
  Crease crease({V(0.09f, 0, 0.05f), V(0.02f, 0, 0)});
  crease.graph.patches[1].normal = V(std::sin(0.25f), 0, std::cos(0.25f));  // 14.3 deg
  EXPECT_EQ(crease.cut(), (std::vector<std::int32_t>{0, 1}));
}

TEST(Creases, NoPatchLosesItsLastPoints) {
  Crease crease({V(0.01f, 0, 0), V(0.02f, 0, 0), V(0.03f, 0, 0)});
  EXPECT_EQ(crease.cut(), (std::vector<std::int32_t>{0, 0, 1}));
  EXPECT_EQ(crease.graph.patches[1].point_count, 1u);
}

TEST(Creases, PointsInNoPatchStayInNone) {
  Crease crease({V(0.1f, 0, 0.1f), V(0.05f, 0, 0), V(0.1f, 0, 0.1f)});
  crease.graph.point_patch[0] = kNone;
  --crease.graph.patches[0].point_count;
  EXPECT_EQ(crease.cut(), (std::vector<std::int32_t>{kNone, 0, 1}));
}

// The three faces of a corner, sampled off the grid of voxels: of a patch that holds points of two
// faces, all but its main one's are counted. Voxels alone leave 7 %.
TEST(Creases, AlongTheEdgesOfACornerPatchesHoldOneFace) {
  PointCloud cloud;
  std::vector<int> face;
  constexpr float kStep = 0.005f;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      const float u = (static_cast<float>(i) + 0.37f) * kStep;
      const float v = (static_cast<float>(j) + 0.61f) * kStep;
      for (int f = 0; f < 3; ++f) {
        V p(0.013f, 0.007f, 0.011f);
        p[f] += u, p[(f + 1) % 3] += v;
        cloud.positions.push_back(p);
        face.push_back(f);
      }
    }
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  PatchOptions options;
  options.voxel_size = 0.02;
  options.patch_size = 0.08;
  const PatchGraph graph = make_patches(cloud, options);
  std::map<std::int32_t, std::array<std::size_t, 3>> held;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_NE(graph.point_patch[i], kNone);
    ++held[graph.point_patch[i]][static_cast<std::size_t>(face[i])];
  }
  std::size_t stray = 0;
  for (const auto& [patch, of_face] : held) {
    const std::size_t all = of_face[0] + of_face[1] + of_face[2];
    EXPECT_EQ(graph.patches[static_cast<std::size_t>(patch)].point_count, all);
    stray += all - *std::max_element(of_face.begin(), of_face.end());
  }
  EXPECT_EQ(held.size(), graph.patches.size());
  EXPECT_LT(static_cast<double>(stray) / static_cast<double>(cloud.size()), 0.05);
}

}  // namespace
}  // namespace planescope
