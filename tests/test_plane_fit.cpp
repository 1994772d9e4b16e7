// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "planes/plane_fit.hpp"
#include "planes/random.hpp"
#include "planes_fixtures.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;
using V = Eigen::Vector3f;

double degrees_between(const V& a, const V& b) {
  return std::acos(std::min(1.0f, a.dot(b))) * 180 / std::acos(-1.0);
}

TEST(FitPlane, RecoversATiltedPlaneAndIgnoresWhatIsNearby) {
  PatchGraphBuilder scene(0.1f, 0.002f, 0.05f, 3);
  const V normal = V(0.1f, -0.2f, 1).normalized();
  scene.rectangle(V(1, 1, 2), 2 * normal.cross(V::UnitX()).normalized(),
                  2 * normal.cross(normal.cross(V::UnitX())).normalized());
  const PatchIndex index(scene.finish().patches);
  const Plane start{V(0, 0, 1), 2};
  const Bits all = index.inliers({.plane = start, .half_width = 10, .gate = 0});
  Plane plane = fit_plane(index, all, start, 10);
  for (int step = 0; step < 5; ++step) plane = fit_plane(index, all, plane, 0.05);
  EXPECT_LT(degrees_between(plane.normal, normal), 0.1);
  EXPECT_NEAR(plane.distance, normal.dot(V(1, 1, 2)), 0.002);
}

TEST(FitPlane, OneStepIsTheWeightedFitInDoublePrecision) {
  std::mt19937_64 random(9);
  const auto unit = [&] { return static_cast<float>(2 * uniform_unit(random) - 1); };
  std::vector<Patch> patches(500);
  for (Patch& patch : patches) {
    patch.centroid = V(30 + 3 * unit(), -20 + 2 * unit(), 5 + 0.06f * unit());
    patch.normal = V(0.2f * unit(), 0.2f * unit(), unit() < 0 ? -1.0f : 1.0f).normalized();
    patch.area = 0.01f + 0.005f * unit();
    patch.scale = 1 + 0.5f * unit();
  }
  const PatchIndex index(patches);
  const Plane start{V(0.01f, -0.01f, 1).normalized(), 5.49f};
  const double sigma = 0.1;
  const Bits members = index.inliers({.plane = start, .half_width = 0.1f, .gate = 0.97f});
  ASSERT_GT(count(members), 100u);
  double sum = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const auto for_each_weighted = [&](const auto& use) {
    for_each(members, [&](std::size_t i) {
      const Patch& patch = patches[index.patch(i)];
      const double r = double(start.normal.cast<double>().dot(patch.centroid.cast<double>()) -
                              double(start.distance)) /
                       (sigma * double(patch.scale));
      use(double(patch.area) * std::pow(std::max(0.0, 1 - r * r), 2),
          patch.centroid.cast<double>());
    });
  };
  for_each_weighted([&](double w, const Eigen::Vector3d& p) { sum += w, mean += w * p; });
  mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for_each_weighted([&](double w, const Eigen::Vector3d& p) {
    covariance += w / sum * (p - mean) * (p - mean).transpose();
  });
  const Eigen::Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  const Plane plane = fit_plane(index, members, start, sigma);
  EXPECT_LT(1 - std::abs(plane.normal.cast<double>().dot(normal)), 1e-9);
  EXPECT_NEAR(plane.signed_distance(mean.cast<float>()), 0, 1e-5);
}

TEST(FitPlane, GoesByTheNormalsWhereCentroidsFixNoPlane) {
  PatchGraph line;
  for (int i = 0; i < 10; ++i) {
    Patch patch;
    patch.centroid = {0.1f * static_cast<float>(i), 0, 1};
    patch.normal = V(0, 0.6f, i % 2 == 0 ? 0.8f : -0.8f);
    if (i % 2 != 0) patch.normal.y() = -0.6f;  // the same plane from behind
    line.patches.push_back(patch);
  }
  const PatchIndex index(line.patches);
  const Plane start{V(0, 0, 1), 1};
  const Bits all = index.inliers({.plane = start, .half_width = 1, .gate = 0});
  EXPECT_LT(degrees_between(fit_plane(index, all, start, 0.05).normal, V(0, 0.6f, 0.8f)), 0.1);
}

}  // namespace
}  // namespace planescope
