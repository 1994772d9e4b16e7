// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "patches/smoothing.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

using testing::add_rectangle;
using testing::Uniform;
using V = Eigen::Vector3f;

float gauss(Uniform& uniform) {  // twelve uniform numbers: variance 1
  float sum = -6;
  for (int k = 0; k < 12; ++k) sum += uniform();
  return sum;
}

// A wall and a floor of a metre each that meet at the y axis, scattered by `noise` [m].
PointCloud make_corner(float noise) {
  PointCloud cloud;
  Uniform uniform(3);
  add_rectangle(cloud, uniform, 40'000, V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), 1);
  add_rectangle(cloud, uniform, 40'000, V(0, 0, 0), V(0, 1, 0), V(0, 0, 1), 2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud.positions[i][cloud.labels[i] == 1 ? 2 : 0] += noise * gauss(uniform);
  }
  return cloud;
}

// Root mean square distance from their surface of the points of one label, at least `from` away
// from the edge and the rims.
double scatter(const PointCloud& cloud, const std::vector<std::uint32_t>& labels,
               std::uint32_t label, float from) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const V& p = cloud.positions[i];
    const float along = label == 1 ? p.x() : p.z(), off = label == 1 ? p.z() : p.x();
    if (labels[i] != label || along < from || along > 0.9f || p.y() < 0.1f || p.y() > 0.9f)
      continue;
    sum += double(off) * double(off);
    count += 1;
  }
  return std::sqrt(sum / count);
}

TEST(Smoothing, ThinsScatteredWallsAndKeepsTheirCorner) {
  const PointCloud cloud = make_corner(0.03f);
  const PointCloud smooth = smooth_points(cloud, 0.03);
  for (const std::uint32_t label : {1u, 2u}) {
    EXPECT_NEAR(scatter(cloud, cloud.labels, label, 0.25f), 0.03, 0.002);
    EXPECT_LT(scatter(smooth, cloud.labels, label, 0.25f), 0.006);
    EXPECT_LT(scatter(smooth, cloud.labels, label, 0.08f), 0.012);  // next to the corner
  }
}

TEST(Smoothing, LeavesThinSurfacesWhereTheyAre) {
  const PointCloud cloud = make_corner(0.001f);
  const PointCloud smooth = smooth_points(cloud, 0.02);
  EXPECT_LT(scatter(smooth, cloud.labels, 1, 0.05f), 0.0015);
  EXPECT_LT(scatter(smooth, cloud.labels, 2, 0.05f), 0.0015);
  EXPECT_LT(scatter(smooth, cloud.labels, 1, 0.02f), 0.004);  // a cell from the corner
}

TEST(Smoothing, PointsWithoutSurroundingsStay) {
  PointCloud cloud = make_corner(0.03f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cloud.positions.push_back(V(5, 5, 5));
  cloud.positions.push_back(V(nan, 0, 0));
  const PointCloud smooth = smooth_points(cloud, 0.03);
  ASSERT_EQ(smooth.size(), cloud.size());
  EXPECT_EQ(smooth.positions[80'000], V(5, 5, 5));
  EXPECT_FALSE(is_finite(smooth.positions[80'001]));
}

TEST(Smoothing, SameAtAnyNumberOfThreads) {
  const PointCloud cloud = make_corner(0.02f);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return smooth_points(cloud, 0.03).positions;
  };
  EXPECT_EQ(run(1), run(2));
}

}  // namespace
}  // namespace planescope
