// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "automatic.hpp"
#include "planescope/error.hpp"
#include "planescope/options.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

TEST(Scale, SpacingIsThatOfTheDensity) {
  // 4000 points a square metre: each stands for a square of 1 / sqrt(4000) = 15.8 mm.
  const CloudScale scale = measure_scale(testing::make_box_room(4000));
  EXPECT_NEAR(scale.spacing, 0.0158, 0.0016);
  EXPECT_LT(scale.noise, 0.0005);
  EXPECT_NEAR(scale.extent.x(), 3.0, 0.1);
  EXPECT_NEAR(scale.extent.z(), 2.0, 0.1);
  EXPECT_EQ(scale.finite_points, 26u * 4000u);
}

TEST(Scale, NoiseIsThatOfTheSurface) {
  PointCloud cloud;
  testing::Uniform uniform(2);
  testing::add_rectangle(cloud, uniform, 40000, {0, 0, 0}, {2, 0, 0}, {0, 2, 0});
  for (Eigen::Vector3f& p :
       cloud.positions) {  // uniform noise of +- 5 mm: deviation 10 mm / sqrt(12)
    p.z() = 0.01f * (uniform() - 0.5f);
  }
  EXPECT_NEAR(measure_scale(cloud).noise, 0.01 / std::sqrt(12.0), 0.0004);
}

TEST(Scale, OneOutlierAndNonFinitePointsDoNotMatter) {
  PointCloud cloud = testing::make_box_room(2000);
  const CloudScale clean = measure_scale(cloud);
  cloud.positions[17] = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
  cloud.positions[18].x() = 1e9f;
  const CloudScale scale = measure_scale(cloud);
  EXPECT_NEAR(scale.spacing, clean.spacing, 0.02 * clean.spacing);
  EXPECT_LT((scale.extent - clean.extent).norm(), 0.05f);
}

TEST(Scale, DegenerateCloudsAreLegalOrRefused) {
  PointCloud cloud;
  EXPECT_THROW(measure_scale(cloud), Error);
  for (const std::size_t count : {1u, 2u, 3u, 1000u}) {
    cloud.positions.assign(count, Eigen::Vector3f(1, 2, 3));
    const CloudScale scale = measure_scale(cloud);
    EXPECT_GT(scale.spacing, 0);
    EXPECT_TRUE(std::isfinite(scale.noise));
  }
}

// A fused map: walls at a slant, where the points lie 7.7 mm apart, and a table top along the map's
// axes, where they lie in rows a centimetre apart. Voxels of 1.05 spacings leave every fifth row
// empty, and cut the table top into tiles, though not the walls.
TEST(Scale, RowsOfFusedMapsHangTogether) {
  PointCloud cloud;
  testing::Uniform uniform(6);
  const auto wall = [&](const Eigen::Vector3f& u, const Eigen::Vector3f& v) {
    testing::add_rectangle(cloud, uniform, 67'000, {0, 0, 0}, u, v);
  };
  wall({1.6F, 1.2F, 0}, {0, 0, 2});
  wall({-1.2F, 1.6F, 0}, {0, 0, 2});
  const double walls_alone = measure_scale(cloud).connected_voxel;
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 100; ++column) {
      cloud.positions.emplace_back(0.3F + 0.01F * float(column), 1.8F + 0.01F * float(row), 0.7F);
    }
  }
  cloud.labels.clear();
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  EXPECT_LT(walls_alone, 0.0085);
  EXPECT_GT(measure_scale(cloud).connected_voxel, 0.01);
  EXPECT_LT(measure_scale(cloud).connected_voxel, 0.013);
}

// What was measured need not be measured again.
TEST(Scale, AutomaticTakesAMeasuredScale) {
  const PointCloud cloud = testing::make_box_room(4000);
  const Options once = Options::automatic(cloud);
  const Options again = automatic_options(cloud, measure_scale(cloud));
  for (const OptionInfo& info : option_table())
    EXPECT_EQ(get_option(once, info.name), get_option(again, info.name)) << info.name;
}

}  // namespace
}  // namespace planescope
