// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "synthesis_fixtures.hpp"

namespace planescope {
namespace {

using namespace testing;

TEST(Synthesize, OneViewIsAnOrganisedImageInTheCamerasFrame) {
  SynthesisOptions options = seen(1, 1);
  options.normals = true;
  const SynthesizedScene scene = synthesize(options);
  const PointCloud& cloud = scene.cloud;
  ASSERT_EQ(cloud.width, 640u);
  ASSERT_EQ(cloud.height, 480u);
  ASSERT_EQ(cloud.size(), 640u * 480u);
  ASSERT_TRUE(cloud.sensor.has_value());
  EXPECT_EQ(*cloud.sensor, Eigen::Vector3f(0, 0, 0));
  const auto planes = planes_by_label(scene);
  std::size_t returns = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    ASSERT_EQ(is_finite(p), cloud.labels[i] != 0);
    if (!is_finite(p)) continue;
    ++returns;
    ASSERT_NEAR(525 * p.x() / p.z() + 319.5f, static_cast<float>(i % 640), 1e-3f);
    ASSERT_NEAR(525 * p.y() / p.z() + 239.5f, static_cast<float>(i / 640), 1e-3f);
    ASSERT_GE(p.z(), 0.5f);
    ASSERT_LE(p.z(), 6.0f);
    ASSERT_LT(cloud.normals[i].dot(p), 0) << "a normal looks away from the camera";
    if (is_round(scene.objects[cloud.labels[i] - 1])) continue;
    ASSERT_LT(nearest_plane(p, planes.at(cloud.labels[i])), 0.002f * 6 * p.z() * p.z() + 1e-4f);
  }
  EXPECT_GT(returns, 640u * 480u / 2);
}

TEST(Synthesize, DepthNoiseGrowsWithTheSquareOfDepth) {
  SynthesisOptions options = seen(3, 1);
  options.noise = 0;
  const SynthesizedScene clean = synthesize(options);
  options.noise = 0.004;
  const SynthesizedScene noisy = synthesize(options);
  double near = 0, near_count = 0, far = 0, far_count = 0;
  for (std::size_t i = 0; i < clean.cloud.size(); ++i) {
    const double z = static_cast<double>(clean.cloud.positions[i].z());
    const double error = (static_cast<double>(noisy.cloud.positions[i].z()) - z) / (z * z);
    if (!std::isfinite(error)) continue;
    (z < 2.5 ? near : far) += error * error;
    (z < 2.5 ? near_count : far_count) += 1;
  }
  ASSERT_GT(near_count, 5000);
  ASSERT_GT(far_count, 5000);
  EXPECT_NEAR(std::sqrt(near / near_count), 0.004, 0.0002);
  EXPECT_NEAR(std::sqrt(far / far_count), 0.004, 0.0002);
}

TEST(Synthesize, ManyViewsShareTheRoomsFrame) {
  SynthesisOptions options = seen(2, 3);
  options.normals = true;
  const SynthesizedScene scene = synthesize(options);
  const PointCloud& cloud = scene.cloud;
  EXPECT_FALSE(cloud.organised());
  EXPECT_EQ(cloud.width, cloud.size());
  EXPECT_GT(cloud.size(), 3u * 640 * 480 / 2);
  ASSERT_EQ(scene.planes.front().name, "floor");
  EXPECT_LT((scene.planes.front().plane.normal - Eigen::Vector3f::UnitZ()).norm(), 1e-6f);
  const double whole = synthesize(evenly(2, 1)).planes.front().area;
  EXPECT_GT(scene.planes.front().area, whole / 4);
  EXPECT_LT(scene.planes.front().area, whole * 1.1);
  const auto planes = planes_by_label(scene);
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    ASSERT_TRUE(is_finite(cloud.positions[i]));
    ASSERT_NEAR(cloud.normals[i].norm(), 1, 1e-5);
    if (is_round(scene.objects[cloud.labels[i] - 1])) continue;
    ASSERT_LT(nearest_plane(cloud.positions[i], planes.at(cloud.labels[i])), 0.002 * 6 * 36);
  }
}

}  // namespace
}  // namespace planescope
