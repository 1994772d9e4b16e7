// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/range_warp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/patches.hpp"
#include "planescope/pipeline.hpp"
#include "single_scan.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

using Eigen::Vector3f;

// Ranges 1, 2 and 4 m from (1, 0, 0): the median is 2 m.
RangeWarp make_warp(double exponent) {
  PointCloud cloud;
  cloud.positions = {{2, 0, 0}, {1, 2, 0}, {1, 0, 4}};
  return {cloud, exponent, Vector3f(1, 0, 0)};
}

TEST(RangeWarp, WorkedNumbers) {
  const RangeWarp warp = make_warp(0.5);
  // At 8 m: scale (8 / 2)^0.5 = 2, pulled in to 4 m.
  EXPECT_NEAR(warp.scale({1, 8, 0}), 2, 1e-5);
  EXPECT_LT((warp.apply({1, 8, 0}) - Vector3f(1, 4, 0)).norm(), 1e-5);
  EXPECT_LT((warp.apply({3, 0, 0}) - Vector3f(3, 0, 0)).norm(), 1e-5) << "the median range stays";
  EXPECT_TRUE(RangeWarp().identity());
  EXPECT_EQ(RangeWarp().apply({1, 2, 3}), Vector3f(1, 2, 3));
}

TEST(RangeWarp, InvertUndoesApply) {
  for (const double exponent : {0.0, 0.3, 0.7, 0.9}) {
    const RangeWarp warp = make_warp(exponent);
    for (const Vector3f& p : {Vector3f(4, -5, 6), Vector3f(1.1f, 0, 0), Vector3f(-30, 20, 7)}) {
      EXPECT_LT((warp.invert(warp.apply(p)) - p).norm(), 1e-4f * p.norm()) << exponent;
    }
  }
}

// A small square is warped corner by corner; its area there is what `cells` of a regular grid see.
TEST(RangeWarp, AreaIsThatOfTheSurface) {
  const RangeWarp warp = make_warp(0.6);
  const Vector3f centre(3, 2, 4);
  constexpr float kSide = 1e-2f, kSize = 0.01f;
  for (const Vector3f& direction : {Vector3f(1, 0, 0), Vector3f(1, 2, 3), Vector3f(2, 2, 4)}) {
    const Vector3f normal = direction.normalized();
    const Vector3f u = normal.unitOrthogonal() * kSide, v = normal.cross(u);
    const auto at = [&](float a, float b) { return warp.apply(centre + a * u + b * v); };
    const Vector3f warped = (at(0.5f, 0) - at(-0.5f, 0)).cross(at(0, 0.5f) - at(0, -0.5f));
    const float cells = warped.lpNorm<1>() / (kSize * kSize);  // |n|_1 A / size^2
    EXPECT_NEAR(warp.area(centre, normal, cells, kSize), kSide * kSide, 0.02f * kSide * kSide);
  }
}

// A tripod's scan of a box room, 6 x 4 x 3 m, from 1.5 m above a corner of the floor: rays every
// degree both ways.
PointCloud make_tripod_scan() {
  PointCloud cloud;
  const Eigen::AlignedBox3f room(Vector3f(-1, -1, -1.5f), Vector3f(5, 3, 1.5f));
  constexpr float kDegree = std::numbers::pi_v<float> / 180;
  for (int elevation = -75; elevation <= 75; ++elevation) {
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
      const float e = float(elevation) * kDegree, a = float(azimuth) * kDegree;
      const Vector3f ray(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
      const Vector3f wall = (ray.array() > 0).select(room.max(), room.min());
      cloud.positions.push_back(ray * wall.cwiseQuotient(ray).cwiseAbs().minCoeff());
    }
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

TEST(SingleScan, IsToldFromAMap) {
  const CloudScale scan = measure_scale(make_tripod_scan());
  EXPECT_GT(scan.median_range, 1);
  EXPECT_LT(scan.median_range, scan.far_range);
  EXPECT_EQ(measure_scale(testing::make_box_room(4000)).median_range, 0) << "even density";
  PointCloud layered = make_tripod_scan();  // the same twice, the second room around the first
  const std::size_t once = layered.size();
  for (std::size_t i = 0; i < once; ++i) layered.positions.push_back(2 * layered.positions[i]);
  layered.width = static_cast<std::uint32_t>(layered.size());
  EXPECT_EQ(measure_scale(layered).median_range, 0) << "surfaces behind surfaces";
}

TEST(SingleScan, CorrelationAndLayersOfWorkedCases) {
  const Sighting steps[] = {{1, 16}, {2, 4}, {4, 1}};  // spacing in proportion to the range
  EXPECT_NEAR(spacing_correlation(steps), 1, 1e-6);
  const Sighting even[] = {{1, 5}, {2, 5}};
  EXPECT_EQ(spacing_correlation(even), 0);
  PointCloud cloud;
  cloud.positions = {
      {1, 0.001f, 0.001f}, {2, 0.001f, 0.001f}, {0.001f, 1, 0.001f}, {0.001f, 1.1f, 0.001f}};
  const std::uint32_t all[] = {0, 1, 2, 3};
  EXPECT_NEAR(layered_share(cloud, all, Vector3f::Zero()), 0.5, 1e-6);
}

// The far walls' lines lie several uniform voxels apart; with the range they meet.
TEST(SingleScan, FarWallsHoldTogether) {
  const PointCloud cloud = make_tripod_scan();
  Options growing = Options::automatic(cloud);
  EXPECT_EQ(growing.patches.range_exponent, kScanRangeExponent);
  Options uniform = growing;
  uniform.patches.range_exponent = 0;
  const Segmentation with = segment(cloud, growing), without = segment(cloud, uniform);
  const auto share_of_largest_six = [](const Segmentation& scene) {
    std::vector<double> points(scene.segments.segments.size() + 1, 0);
    for (const std::uint32_t label : scene.point_label) points[label] += label > 0 ? 1 : 0;
    std::sort(points.begin(), points.end(), std::greater());
    points.resize(std::min<std::size_t>(points.size(), 6));
    return std::accumulate(points.begin(), points.end(), 0.0) / double(scene.point_label.size());
  };
  EXPECT_GT(share_of_largest_six(with), 0.98) << "floor, ceiling and four walls";
  EXPECT_LT(share_of_largest_six(without), 0.9);
  for (const Patch& patch : with.graph.patches) {
    EXPECT_LT(patch.normal.dot(patch.centroid), 0) << "towards the scanner in the origin";
  }
}

}  // namespace
}  // namespace planescope
