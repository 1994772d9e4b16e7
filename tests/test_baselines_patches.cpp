// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numbers>

#include "baselines/baselines.hpp"
#include "baselines/voxel_graph.hpp"
#include "baselines_scene.hpp"

namespace planescope {
namespace {

using namespace planescope::testing;

TEST(BaselinesPatches, PatchesDescribeThePointsTheyHold) {
  const PointCloud cloud = toy_scene();
  const PatchOptions options{.voxel_size = 0.0075, .patch_size = 0.03};
  const PatchGraph graph = pcl_patches(cloud, options);
  ASSERT_EQ(graph.point_patch.size(), cloud.size());
  std::vector<std::uint32_t> count(graph.patches.size(), 0);
  std::vector<Eigen::Vector3d> sum(graph.patches.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (graph.point_patch[i] == kNone) continue;
    ASSERT_LT(static_cast<std::size_t>(graph.point_patch[i]), graph.patches.size());
    ++count[static_cast<std::size_t>(graph.point_patch[i])];
    sum[static_cast<std::size_t>(graph.point_patch[i])] += cloud.positions[i].cast<double>();
  }
  double area = 0;
  for (std::size_t p = 0; p < graph.patches.size(); ++p) {
    const Patch& patch = graph.patches[p];
    EXPECT_EQ(patch.point_count, count[p]);
    EXPECT_GT(patch.voxel_count, 0U);
    EXPECT_NEAR(patch.normal.norm(), 1.0F, 1e-4F);
    EXPECT_GT(patch.normal.dot(*cloud.sensor - patch.centroid), 0.0F);
    EXPECT_NEAR(patch.color.x(), 200.0F, 1.5F);
    // A mean of voxel means and a mean of points differ by less than a voxel.
    EXPECT_LT((patch.centroid - (sum[p] / count[p]).cast<float>()).norm(), 0.0075F);
    EXPECT_LE(patch.curvature, 1.0F / 3.0F);
    area += static_cast<double>(patch.area);
  }
  // 0.8 x 0.6 minus two footprints, plus six faces of 12 cm; the grid is coarse.
  EXPECT_NEAR(area, 0.48 - 2 * 0.0144 + 6 * 0.0144, 0.1);
  // Flat in the middle of the table, bent at boxes' edges.
  float flattest = 1, most_bent = 0;
  for (const Patch& patch : graph.patches) {
    flattest = std::min(flattest, patch.curvature);
    most_bent = std::max(most_bent, patch.curvature);
  }
  EXPECT_LT(flattest, 1e-6F);
  EXPECT_GT(most_bent, 0.05F);
}

/// Borders by brute force over all pairs of voxels, found from the points alone.
TEST(BaselinesPatches, BordersCountVoxelPairs) {
  const PointCloud cloud = toy_scene();
  const PatchOptions options{.voxel_size = 0.01, .patch_size = 0.05};
  const PatchGraph graph = pcl_patches(cloud, options);
  // PCL works relative to the sensor, in float.
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
  for (const Eigen::Vector3f& p : cloud.positions)
    if (is_finite(p))
      low = low.cwiseMin(p - *cloud.sensor), high = high.cwiseMax(p - *cloud.sensor);
  const auto voxel = static_cast<double>(0.01F);
  const Eigen::Vector3d origin = octree_origin(low, high, voxel);
  std::map<std::array<int, 3>, std::int32_t> cells;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i])) continue;
    const Eigen::Vector3f seen = cloud.positions[i] - *cloud.sensor;
    const Eigen::Vector3d at = (seen.cast<double>() - origin) / voxel;
    cells[{static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z())}] =
        graph.point_patch[i];
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> borders;
  for (auto a = cells.begin(); a != cells.end(); ++a)
    for (auto b = std::next(a); b != cells.end() && b->first[0] <= a->first[0] + 1; ++b) {
      if (a->second == b->second || a->second == kNone || b->second == kNone) continue;
      if (std::abs(a->first[1] - b->first[1]) > 1 || std::abs(a->first[2] - b->first[2]) > 1)
        continue;
      const auto [first, second] = std::minmax(a->second, b->second);
      ++borders[{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second)}];
    }
  ASSERT_EQ(graph.adjacency.size(), borders.size());
  auto expected = borders.begin();
  for (const Adjacency& pair : graph.adjacency) {
    EXPECT_EQ(std::pair(pair.first, pair.second), expected->first);
    EXPECT_EQ(pair.border, expected->second) << pair.first << " - " << pair.second;
    ++expected;
  }
}

TEST(BaselinesPatches, GivenNormalsWin) {
  PointCloud cloud;
  add_face(cloud, {0, 0, 0}, {0.3F, 0, 0}, {0, 0.3F, 0}, 1);
  cloud.sensor = Eigen::Vector3f(0, 0, 1);
  cloud.normals.assign(cloud.size(), -Eigen::Vector3f::UnitZ());
  cloud.normals[5].setConstant(std::numeric_limits<float>::quiet_NaN());
  for (const Patch& patch : pcl_patches(cloud, {.voxel_size = 0.01, .patch_size = 0.05}).patches)
    EXPECT_LT(patch.normal.z(), -0.999F);
}

/// Patches of known shape: a square in z = 0 and a slanted line of voxels. Two points a voxel.
TEST(BaselinesPatches, PatchMeasuresByHand) {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::int32_t> patch;
  const auto add = [&](float x, float y, float z, std::int32_t id) {
    points.insert(points.end(), {{x + 0.4F, y + 0.4F, z + 0.5F}, {x + 0.6F, y + 0.6F, z + 0.5F}});
    patch.insert(patch.end(), {id, id});
  };
  for (const auto& [x, y] : {std::pair(0.0F, 0.0F), {1, 0}, {0, 1}, {1, 1}}) add(x, y, 0, 0);
  for (const float t : {0.0F, 1.0F, 2.0F}) add(2 + t, 0, t, 1);
  // Corners fix PCL's grid: 8 voxels a side from (0,0,0); these points are in no patch.
  points.insert(points.end(), {{0, 0, 0}, {8, 8, 8}});
  patch.insert(patch.end(), {kNone, kNone});
  const std::vector<Rgb> colors(points.size(), Rgb{10, 20, 30});
  const PatchVoxels voxels = make_voxels(points, colors, patch, 1.0);
  ASSERT_EQ(voxels.keys.size(), 7U);
  std::vector<Patch> patches(2);
  const float half = 1.0F / std::numbers::sqrt2_v<float>;
  patches[1].normal = {-half, 0, half};
  measure_patches(voxels, patches);
  EXPECT_LT((patches[0].centroid - Eigen::Vector3f(1, 1, 0.5F)).norm(), 1e-6F);
  EXPECT_EQ(patches[0].voxel_count, 4U);
  EXPECT_FLOAT_EQ(patches[0].area, 4.0F);
  EXPECT_NEAR(patches[0].curvature, 0.0F, 1e-7F);
  EXPECT_FLOAT_EQ(patches[1].area, 3.0F / std::numbers::sqrt2_v<float>);
  EXPECT_EQ(patches[1].color, Eigen::Vector3f(10, 20, 30));
  // (1,0,0) and (1,1,0) of the square touch (2,0,0) of the line.
  EXPECT_EQ(find_borders(voxels), (std::vector<Adjacency>{{0, 1, 2}}));
}

}  // namespace
}  // namespace planescope
