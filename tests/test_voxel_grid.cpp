// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "patches/occupancy.hpp"
#include "patches/voxel_blocks.hpp"
#include "patches/voxel_grid.hpp"
#include "planescope/error.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

using Cell = std::array<int, 3>;

// The same grid by a std::map: cell -> its points.
std::map<Cell, std::vector<std::size_t>> brute_force_cells(const PointCloud& cloud,
                                                           const VoxelGrid& grid) {
  std::map<Cell, std::vector<std::size_t>> cells;
  const float inverse = static_cast<float>(1.0 / double(grid.size));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i])) continue;
    const Eigen::Vector3f q = (cloud.positions[i] - grid.lower) * inverse;
    cells[{int(std::floor(q.x())), int(std::floor(q.y())), int(std::floor(q.z()))}].push_back(i);
  }
  return cells;
}

PointCloud random_cloud(int count) {
  PointCloud cloud;
  testing::Uniform uniform(3);
  for (int i = 0; i < count; ++i) {
    cloud.positions.emplace_back(uniform(), uniform() * 0.8f, uniform() * 0.3f);
    cloud.colors.push_back({static_cast<std::uint8_t>(i % 256), 7, 9});
  }
  cloud.positions[5].x() = std::numeric_limits<float>::quiet_NaN();
  cloud.positions[6].z() = std::numeric_limits<float>::infinity();
  cloud.width = static_cast<std::uint32_t>(count);
  return cloud;
}

TEST(VoxelGrid, MatchesBruteForce) {
  const PointCloud cloud = random_cloud(3000);
  const VoxelGrid grid = make_voxel_grid(cloud, 0.05, true);
  const auto cells = brute_force_cells(cloud, grid);
  ASSERT_EQ(grid.voxel_count(), cells.size());
  EXPECT_EQ(grid.point_voxel[5], kNoVoxel);
  EXPECT_EQ(grid.point_voxel[6], kNoVoxel);
  std::map<Cell, std::uint32_t> voxel_of;
  for (const auto& [cell, points] : cells) {
    const std::uint32_t voxel = grid.point_voxel[points.front()];
    voxel_of[cell] = voxel;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double red = 0;
    for (const std::size_t i : points) {
      EXPECT_EQ(grid.point_voxel[i], voxel);
      sum += cloud.positions[i].cast<double>();
      red += cloud.colors[i].r;
    }
    const auto count = static_cast<double>(points.size());
    EXPECT_EQ(grid.point_count[voxel], points.size());
    EXPECT_LT((grid.mean[voxel].cast<double>() - sum / count).norm(), 1e-6);
    EXPECT_NEAR(grid.color[voxel].x(), red / count, 1e-3);
  }
  for (const auto& [cell, voxel] : voxel_of) {
    std::set<std::uint32_t> expected;
    for (int i = 0; i < 27; ++i) {
      if (i == 13) continue;
      const auto found =
          voxel_of.find({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
      if (found != voxel_of.end()) expected.insert(found->second);
    }
    const std::set<std::uint32_t> actual(
        grid.neighbours.begin() + grid.neighbour_offsets[voxel],
        grid.neighbours.begin() + grid.neighbour_offsets[voxel + 1]);
    EXPECT_EQ(actual, expected);
    EXPECT_EQ(actual.size(), grid.neighbour_offsets[voxel + 1] - grid.neighbour_offsets[voxel]);
  }
}

TEST(VoxelGrid, SameAtAnyNumberOfThreads) {
  const PointCloud cloud = random_cloud(50000);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return make_voxel_grid(cloud, 0.01, true);
  };
  const VoxelGrid one = run(1), two = run(2), four = run(4);
  EXPECT_EQ(one.point_voxel, two.point_voxel);
  EXPECT_EQ(one.neighbours, two.neighbours);
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.color, two.color);
  EXPECT_EQ(one.mean, four.mean);
}

TEST(Occupancy, SameHoweverManyPartsAThreadMakes) {
  const PointCloud cloud = random_cloud(60000);
  std::vector<std::uint32_t> one_part, many_parts;
  const GridBounds bounds{Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(1e9f)};
  const VoxelBlocks one = find_occupied(cloud, bounds, 100, one_part);
  const VoxelBlocks many = find_occupied(cloud, bounds, 100, many_parts, 10);
  EXPECT_EQ(one_part, many_parts);
  EXPECT_EQ(one.keys, many.keys);
  EXPECT_EQ(one.voxel_count, many.voxel_count);
}

TEST(VoxelGrid, RefusesWhatHasNoGrid) {
  PointCloud cloud;
  cloud.positions.assign(3, Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_THROW(make_voxel_grid(cloud, 0.01, false), Error);
  cloud.positions = {Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1e9f, 0, 0)};
  try {
    make_voxel_grid(cloud, 0.01, false);
    FAIL() << "an extent of 1e11 voxels was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Computation);
  }
}

TEST(VoxelGrid, OnePointAndManyEqualPoints) {
  PointCloud cloud;
  cloud.positions.assign(100000, Eigen::Vector3f(0.1f, 0.2f, 0.3f));
  const VoxelGrid grid = make_voxel_grid(cloud, 0.01, false);
  ASSERT_EQ(grid.voxel_count(), 1u);
  EXPECT_EQ(grid.point_count[0], 100000u);
  EXPECT_EQ(grid.mean[0], cloud.positions[0]);
  EXPECT_TRUE(grid.neighbours.empty());
}

TEST(BlockMap, FindsWhatWasInsertedAndNothingElse) {
  BlockMap map(2);
  for (std::uint64_t k = 0; k < 5000; ++k) EXPECT_EQ(map.insert(k * k * 977), k);
  for (std::uint64_t k = 0; k < 5000; ++k) EXPECT_EQ(map.find(k * k * 977), k);
  EXPECT_EQ(map.insert(977), 1u);
  EXPECT_EQ(map.find(978), BlockMap::kAbsent);
}

}  // namespace
}  // namespace planescope
