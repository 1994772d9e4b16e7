// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <set>

#include "patches/orientation.hpp"
#include "planescope/patches.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

using testing::make_box_room;

PatchOptions room_options() {
  PatchOptions options;
  options.voxel_size = 0.03;
  options.patch_size = 0.2;
  return options;
}

TEST(Patches, CoverTheRoomAndAreFlat) {
  const PointCloud cloud = make_box_room(4000);
  const PatchGraph graph = make_patches(cloud, room_options());
  ASSERT_EQ(graph.point_patch.size(), cloud.size());
  std::set<std::int32_t> used(graph.point_patch.begin(), graph.point_patch.end());
  EXPECT_EQ(used.count(kNone), 0u);  // dense surfaces leave no hole
  EXPECT_EQ(used.size(), graph.patches.size());
  EXPECT_EQ(*used.rbegin() + 1, static_cast<std::int32_t>(graph.patches.size()));  // contiguous
  // 26 m^2 in patches of 0.2 m: 650, less what corners share.
  EXPECT_GT(graph.patches.size(), 400u);
  EXPECT_LT(graph.patches.size(), 1300u);
  double area = 0;
  std::size_t points = 0, flat = 0;
  for (const Patch& patch : graph.patches) {
    area += double(patch.area);
    points += patch.point_count;
    EXPECT_NEAR(patch.normal.norm(), 1.0f, 1e-4f);
    flat += patch.normal.cwiseAbs().maxCoeff() > 0.99f;
  }
  EXPECT_EQ(points, cloud.size());
  EXPECT_NEAR(area, 26.0, 3.0);
  EXPECT_GT(double(flat), 0.85 * double(graph.patches.size()));
}

TEST(Patches, AdjacencyIsSortedUniqueAndConnectsTheRoom) {
  const PatchGraph graph = make_patches(make_box_room(4000), room_options());
  for (std::size_t e = 0; e < graph.adjacency.size(); ++e) {
    const Adjacency& edge = graph.adjacency[e];
    EXPECT_LT(edge.first, edge.second);
    EXPECT_LT(edge.second, graph.patches.size());
    EXPECT_GT(edge.border, 0u);
    if (e == 0) continue;
    const Adjacency& last = graph.adjacency[e - 1];
    EXPECT_TRUE(last.first < edge.first || (last.first == edge.first && last.second < edge.second));
  }
  const NeighbourTable table = make_neighbour_table(graph.patches.size(), graph.adjacency);
  std::set<std::uint32_t> reached = {0};
  std::vector<std::uint32_t> queue = {0};
  while (!queue.empty()) {
    const std::uint32_t p = queue.back();
    queue.pop_back();
    for (std::size_t k = table.offsets[p]; k < table.offsets[p + 1]; ++k) {
      EXPECT_TRUE(graph.adjacency[table.edges[k]].first == p ||
                  graph.adjacency[table.edges[k]].second == p);
      if (reached.insert(table.neighbours[k]).second) queue.push_back(table.neighbours[k]);
    }
  }
  EXPECT_EQ(reached.size(), graph.patches.size());
}

TEST(Patches, KeepToOneSideOfAnEdge) {
  const PointCloud cloud = make_box_room(4000);
  const PatchGraph graph = make_patches(cloud, room_options());
  // Points well away from any other surface share their patch with points of their own surface
  // only.
  std::vector<std::array<std::size_t, 6>> votes(graph.patches.size());
  for (auto& v : votes) v.fill(0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ++votes[static_cast<std::size_t>(graph.point_patch[i])][cloud.labels[i]];
  }
  std::size_t minority = 0;
  for (const auto& v : votes) {
    std::size_t total = 0, most = 0;
    for (const std::size_t n : v) {
      total += n;
      most = std::max(most, n);
    }
    minority += total - most;
  }
  EXPECT_LT(double(minority),
            0.025 * double(cloud.size()));  // a voxel along 18 m of edges is 2.1 %
}

TEST(Patches, SameAtAnyNumberOfThreads) {
  const PointCloud cloud = make_box_room(4000);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return make_patches(cloud, room_options());
  };
  const PatchGraph one = run(1), two = run(2);
  EXPECT_EQ(one.point_patch, two.point_patch);
  EXPECT_EQ(one.adjacency, two.adjacency);
  for (std::size_t p = 0; p < one.patches.size(); ++p) {
    EXPECT_EQ(one.patches[p].normal, two.patches[p].normal);
    EXPECT_EQ(one.patches[p].centroid, two.patches[p].centroid);
  }
}

TEST(Patches, NormalsFaceTheSensor) {
  PointCloud cloud = make_box_room(2000);
  cloud.sensor = Eigen::Vector3f(1.5f, 1.0f, 1.0f);
  for (const Patch& patch : make_patches(cloud, room_options()).patches) {
    EXPECT_GE(patch.normal.dot(*cloud.sensor - patch.centroid), 0);
  }
}

TEST(Patches, NormalsFollowGivenNormals) {
  PointCloud cloud = make_box_room(2000);
  for (const Eigen::Vector3f& p : cloud.positions) {  // outwards, against every heuristic
    cloud.normals.push_back((p - Eigen::Vector3f(1.5f, 1.0f, 1.0f)).normalized());
  }
  std::size_t outwards = 0;
  const PatchGraph graph = make_patches(cloud, room_options());
  for (const Patch& patch : graph.patches) {
    outwards += patch.normal.dot(patch.centroid - Eigen::Vector3f(1.5f, 1.0f, 1.0f)) > 0;
  }
  EXPECT_EQ(outwards, graph.patches.size());
}

TEST(Patches, NormalsFaceTheInsideWhereNothingIsKnown) {
  const PatchGraph graph = make_patches(make_box_room(2000), room_options());
  std::size_t inwards = 0;
  for (const Patch& patch : graph.patches) {
    inwards += patch.normal.dot(Eigen::Vector3f(1.5f, 1.0f, 1.0f) - patch.centroid) > 0;
  }
  EXPECT_GT(double(inwards), 0.98 * double(graph.patches.size()));
}

TEST(Orientation, AgreesAcrossSharpCornersOfBothKinds) {
  // A floor patch, a wall patch above it (concave) and the side of a step below it (convex), with
  // scrambled signs.
  PatchGraph graph;
  const auto add = [&](const Eigen::Vector3f& centroid, const Eigen::Vector3f& normal) {
    Patch patch;
    patch.centroid = centroid;
    patch.normal = normal;
    patch.area = 1;
    graph.patches.push_back(patch);
  };
  add({0, 0, 0}, {0, 0, -1});   // floor
  add({1, 0, 1}, {-1, 0, 0});   // wall at x = 1, above: faces -x if the floor faces +z
  add({-1, 0, -1}, {1, 0, 0});  // step's side at x = -1, below: faces -x if the floor faces +z
  graph.adjacency = {{0, 1, 1}, {0, 2, 1}};
  orient_consistently(graph);
  const float up = graph.patches[0].normal.z();
  EXPECT_EQ(graph.patches[1].normal.x(), -up);
  EXPECT_EQ(graph.patches[2].normal.x(), -up);
}

TEST(Patches, NonFinitePointsAreInNone) {
  PointCloud cloud = make_box_room(2000);
  const PatchGraph clean = make_patches(cloud, room_options());
  cloud.positions.insert(cloud.positions.begin(),
                         Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  const PatchGraph graph = make_patches(cloud, room_options());
  EXPECT_EQ(graph.point_patch.front(), kNone);
  EXPECT_TRUE(std::equal(clean.point_patch.begin(), clean.point_patch.end(),
                         graph.point_patch.begin() + 1));
}

TEST(Patches, OneIsolatedPointIsLegal) {
  PointCloud cloud;
  cloud.positions = {Eigen::Vector3f(1, 2, 3)};
  const PatchGraph graph = make_patches(cloud, PatchOptions{});
  EXPECT_EQ(graph.point_patch.size(), 1u);
  EXPECT_LE(graph.patches.size(), 1u);
}

}  // namespace
}  // namespace planescope
