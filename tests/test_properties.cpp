// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include <Eigen/Geometry>

#include "planescope/evaluate.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/synthesize.hpp"

/// \file What must not matter: the order of the points, where and how the scene lies, missing
/// points, the unit of length. (The number of threads: test_pipeline.cpp.)
namespace planescope {
namespace {

SynthesizedScene make_scene(std::uint64_t seed, std::uint64_t points = 60'000) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.points = points;
  return synthesize(options);
}

PointCloud make_room(std::uint64_t seed) { return make_scene(seed).cloud; }

Options fixed_options() {
  Options options = Options::room();
  options.patches.voxel_size = 0.04;
  options.patches.patch_size = 0.16;
  return options;
}

/// How much of the points two labellings agree on: each label of `a` with its best match in `b`.
double agreement(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  return score_labels(a, b).weighted_overlap;
}

class Properties : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(Properties, OrderOfThePoints) {
  const PointCloud cloud = make_room(GetParam());
  std::vector<std::size_t> order(cloud.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937_64(GetParam()));
  PointCloud shuffled = cloud;
  for (std::size_t i = 0; i < order.size(); ++i) shuffled.positions[i] = cloud.positions[order[i]];
  shuffled.colors.clear();
  const Segmentation before = segment(cloud, fixed_options());
  const Segmentation after = segment(shuffled, fixed_options());
  std::vector<std::uint32_t> back(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) back[order[i]] = after.point_label[i];
  EXPECT_EQ(before.planes.size(), after.planes.size());
  EXPECT_GE(agreement(back, before.point_label), 0.9999);  // sums of positions round otherwise
}

TEST_P(Properties, PlaceOfTheScene) {
  PointCloud cloud = make_room(GetParam());
  const Segmentation before = segment(cloud, fixed_options());
  // A multiple of the voxel size that float holds well: the coordinates lose a few bits.
  for (Eigen::Vector3f& p : cloud.positions) p += Eigen::Vector3f(64, -32, 16);
  const Segmentation after = segment(cloud, fixed_options());
  EXPECT_GE(agreement(after.point_label, before.point_label), 0.93);
}

TEST_P(Properties, OriginOfTheMap) {
  PointCloud cloud = make_room(GetParam());
  const Segmentation before = segment(cloud, fixed_options());
  cloud.origin = {691'000, 5'335'000, 520};
  EXPECT_EQ(segment(cloud, fixed_options()).point_label, before.point_label);
}

// Voxels cut a turned scene elsewhere, so patches at borders differ, and with them small segments;
// what carries the scene does not.
TEST_P(Properties, DirectionOfTheScene) {
  const SynthesizedScene room = make_scene(GetParam(), 200'000);
  const Segmentation before = segment(room.cloud, fixed_options());
  for (const float degrees : {90.F, 30.F}) {
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(degrees * std::numbers::pi_v<float> / 180, Eigen::Vector3f::UnitZ())
            .toRotationMatrix();
    PointCloud cloud = room.cloud;
    for (Eigen::Vector3f& p : cloud.positions) p = turn * p;
    cloud.normals.clear();
    std::vector<TruePlane> truth = room.planes;
    for (TruePlane& plane : truth) {
      plane.plane.normal = turn * plane.plane.normal;
      plane.centroid = turn * plane.centroid;
    }
    const Segmentation after = segment(cloud, fixed_options());
    std::vector<Plane> found;
    for (const SupportingPlane& plane : after.planes) found.push_back(plane.plane);
    EXPECT_EQ(score_planes(found, truth, {.angle = 3, .offset = 0.03}).structural_recall, 1.0)
        << degrees;
    EXPECT_GE(agreement(after.point_label, before.point_label), 0.8) << degrees;
  }
}

TEST_P(Properties, MissingPoints) {
  const PointCloud cloud = make_room(GetParam());
  const Segmentation before = segment(cloud, fixed_options());
  PointCloud holed;
  std::vector<std::size_t> kept;
  std::mt19937_64 random(GetParam());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Eigen::Vector3f& p : cloud.positions) {
    if (random() % 100 == 0) holed.positions.emplace_back(nan, p.y(), p.z());
    kept.push_back(holed.positions.size());
    holed.positions.push_back(p);
  }
  const Segmentation after = segment(holed, fixed_options());
  std::vector<std::uint32_t> rest;
  for (const std::size_t i : kept) rest.push_back(after.point_label[i]);
  EXPECT_GT(holed.size(), cloud.size() + cloud.size() / 200);
  EXPECT_EQ(rest, before.point_label);
}

// By a power of two, which float scales without rounding: the same to the last point.
TEST_P(Properties, UnitOfLength) {
  PointCloud cloud = make_room(GetParam());
  Options options = fixed_options();
  const Segmentation before = segment(cloud, options);
  for (const double factor : {4.0, 0.25}) {
    PointCloud scaled = cloud;
    for (Eigen::Vector3f& p : scaled.positions) p *= static_cast<float>(factor);
    Options same = options;
    same.patches.voxel_size *= factor;
    same.patches.patch_size *= factor;
    same.planes.sigma *= factor;
    same.planes.min_area *= factor * factor;
    const Segmentation after = segment(scaled, same);
    EXPECT_EQ(after.planes.size(), before.planes.size()) << factor;
    EXPECT_EQ(after.point_label, before.point_label) << factor;
  }
}

INSTANTIATE_TEST_SUITE_P(Rooms, Properties, ::testing::Values(11U, 12U, 13U));

}  // namespace
}  // namespace planescope
