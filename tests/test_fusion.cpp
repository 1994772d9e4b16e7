// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/fusion.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <functional>
#include <map>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/io.hpp"
#include "planescope/synthesize.hpp"
#include "sequence_fixtures.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;

const DepthCamera kCamera{
    .lens = {.width = 160, .height = 120, .fx = 130, .fy = 130, .cx = 79.5, .cy = 59.5},
    .depth_scale = 10'000};

/// The depth of each pixel by a function of its ray (z = 1).
DepthImage draw(const std::function<double(const Eigen::Vector3d&)>& depth) {
  const PinholeCamera& lens = kCamera.lens;
  DepthImage image{lens.width, lens.height, {}};
  for (std::uint32_t y = 0; y < lens.height; ++y) {
    for (std::uint32_t x = 0; x < lens.width; ++x) {
      const Eigen::Vector3d ray((x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy, 1);
      image.values.push_back(static_cast<std::uint16_t>(std::lround(10'000 * depth(ray))));
    }
  }
  return image;
}

DepthImage wall(double z) {
  return draw([z](const Eigen::Vector3d&) { return z; });
}

/// A ball in front of a wall at 3 m.
const Eigen::Vector3d kCentre(0, 0, 1.2);
constexpr double kRadius = 0.3;
DepthImage ball() {
  return draw([](const Eigen::Vector3d& ray) {
    const double a = ray.squaredNorm(), b = ray.dot(kCentre);
    const double root = b * b - a * (kCentre.squaredNorm() - kRadius * kRadius);
    return root < 0 ? 3.0 : (b - std::sqrt(root)) / a;
  });
}

const Eigen::Isometry3d kHere = Eigen::Isometry3d::Identity();

TEST(Fusion, AWallIsFlatAndFacesTheSensor) {
  TsdfVolume volume;
  volume.integrate(wall(1.503), {}, kCamera, kHere);
  const PointCloud points = volume.points();
  // 160 / 130 * 120 / 130 * 1.503^2 m^2, a point a square centimetre.
  EXPECT_NEAR(static_cast<double>(points.size()), 160.0 * 120 / 130 / 130 * 1.503 * 1.503 * 1e4,
              800);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // The distance is measured along the ray: exact where it is zero, else up to 1 / cos of the
    // ray's angle, which bends the zero between two voxels by a fraction of a millimetre.
    EXPECT_NEAR(points.positions[i].z(), 1.503f, 3e-4f);
    EXPECT_NEAR(points.normals[i].norm(), 1, 1e-5);
    EXPECT_LT(points.normals[i].z(), -0.97f);
  }
  EXPECT_FALSE(points.has_colors());
  EXPECT_TRUE(points.origin.isZero());
}

TEST(Fusion, ABallIsRound) {
  TsdfVolume volume;
  volume.integrate(ball(), {}, kCamera, kHere);
  const PointCloud points = volume.points();
  std::size_t on_ball = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d out = points.positions[i].cast<double>() - kCentre;
    const Eigen::Vector3d ray = points.positions[i].cast<double>().normalized();
    if (out.norm() > 0.35 || -ray.dot(out.normalized()) < 0.5) continue;  // the rim: grazing rays
    ++on_ball;
    EXPECT_NEAR(out.norm(), kRadius, 0.005);
    EXPECT_GT(out.normalized().dot(points.normals[i].cast<double>()), 0.9);
  }
  EXPECT_GT(on_ball, 1000u);
}

TEST(Fusion, TheMeshIsTheSameSurface) {
  TsdfVolume volume;
  volume.integrate(ball(), testing::flat_color({10, 20, 30}, 160, 120), kCamera, kHere);
  const Mesh mesh = volume.mesh();
  const PointCloud points = volume.points();
  ASSERT_EQ(mesh.vertices.positions, points.positions);
  EXPECT_EQ(mesh.vertices.colors.front(), (Rgb{10, 20, 30}));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int k) -> Eigen::Vector3f {
      return points.positions[t[static_cast<std::size_t>(k)]];
    };
    const Eigen::Vector3f normal = (at(1) - at(0)).cross(at(2) - at(0));
    if (normal.norm() > 1e-6f) {
      EXPECT_GT(normal.dot(points.normals[t[0]]), 0);
    }
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  // Each directed edge once: neighbours agree on the orientation. Most have their opposite: few
  // borders.
  std::size_t open = 0;
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    open += edges.contains({edge.second, edge.first}) ? 0 : 1;
  }
  EXPECT_LT(open, edges.size() / 10);
}

TEST(Fusion, MeshFilesAreRead) {
  const TemporaryFolder folder;
  TsdfVolume volume;
  volume.integrate(wall(1), {}, kCamera, kHere);
  const Mesh mesh = volume.mesh();
  write_mesh(mesh, folder / "m.ply");
  const PointCloud back = read_cloud(folder / "m.ply");
  EXPECT_EQ(back.positions, mesh.vertices.positions);
  const std::string bytes = testing::read_bytes(folder / "m.ply");
  EXPECT_EQ(bytes.size(),
            bytes.find("end_header\n") + 11 + 24 * back.size() + 13 * mesh.triangles.size());
}

TEST(Fusion, FramesFromElsewhereMeetInTheWorld) {
  TsdfVolume volume;
  Eigen::Isometry3d back = kHere;  // from the other side of the same wall's place
  back.translate(Eigen::Vector3d(0, 0, -0.5));
  volume.integrate(wall(1.5), {}, kCamera, kHere);
  volume.integrate(wall(2.0), {}, kCamera, back);
  for (const Eigen::Vector3f& p : volume.points().positions) EXPECT_NEAR(p.z(), 1.5f, 1e-3f);
}

TEST(Fusion, WhatWasCarriedAwayGoes) {
  TsdfVolume volume;
  for (int k = 0; k < 5; ++k) volume.integrate(ball(), {}, kCamera, kHere);
  for (int k = 0; k < 60; ++k) volume.integrate(wall(3), {}, kCamera, kHere);
  for (const Eigen::Vector3f& p : volume.points().positions) EXPECT_GT(p.z(), 2.9f);
}

TEST(Fusion, FewObservationsMakeNoSurface) {
  TsdfVolume volume({.min_observations = 2});
  volume.integrate(wall(1), {}, kCamera, kHere);
  EXPECT_THROW(volume.points(), Error);
  volume.integrate(wall(1), {}, kCamera, kHere);
  EXPECT_GT(volume.points().size(), 1000u);
}

TEST(Fusion, MemoryIsTheMapsNotTheFrames) {
  TsdfVolume volume;
  volume.integrate(ball(), {}, kCamera, kHere);
  const std::size_t blocks = volume.block_count();
  for (int k = 0; k < 20; ++k) volume.integrate(ball(), {}, kCamera, kHere);
  EXPECT_EQ(volume.block_count(), blocks);
  EXPECT_EQ(volume.frames(), 21u);
}

TEST(Fusion, ThreadsDoNotMatter) {
  const auto run = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    TsdfVolume volume;
    for (int k = 0; k < 4; ++k) {
      Eigen::Isometry3d pose = kHere;
      pose.rotate(Eigen::AngleAxisd(0.05 * k, Eigen::Vector3d::UnitY()));
      volume.integrate(ball(), testing::flat_color({9, 8, 7}, 160, 120), kCamera, pose);
    }
    return volume.mesh();
  };
  const Mesh one = run(1), four = run(4);
  EXPECT_EQ(one.vertices.positions, four.vertices.positions);
  EXPECT_EQ(one.vertices.normals, four.vertices.normals);
  EXPECT_EQ(one.triangles, four.triangles);
}

TEST(Fusion, BlocksMakeUpTheWhole) {
  TsdfVolume volume;
  for (int k = 0; k < 3; ++k) volume.integrate(ball(), {}, kCamera, kHere);
  PointCloud all;
  for (const BlockKey& block : volume.changed_since(0)) {
    const PointCloud part = volume.block_points(block);
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
  }
  EXPECT_EQ(all.positions, volume.points().positions);
  EXPECT_TRUE(volume.changed_since(3).empty());
  EXPECT_EQ(volume.block_points({1000, 0, 0}).size(), 0u);
}

TEST(Fusion, MapCoordinatesAreKept) {
  TsdfVolume volume;
  Eigen::Isometry3d far = kHere;
  far.translation() = Eigen::Vector3d(4'500'000.25, 0, 0);
  volume.integrate(wall(1), {}, kCamera, far);
  EXPECT_EQ(volume.origin().x(), 4'500'000);
  for (const Eigen::Vector3f& p : volume.points().positions) EXPECT_NEAR(p.z(), 1, 1e-3);
}

TEST(Fusion, WhatCannotBe) {
  EXPECT_THROW(TsdfVolume({.voxel_size = 0}), Error);
  EXPECT_THROW(TsdfVolume({.voxel_size = 0.01, .truncation = 0.01}), Error);
  EXPECT_THROW(TsdfVolume({.min_observations = 256}), Error);
  TsdfVolume volume;
  EXPECT_THROW(volume.integrate(testing::flat_depth(1), {}, kCamera, kHere), Error);
  volume.integrate(wall(1), {}, kCamera, kHere);
  Eigen::Isometry3d away = kHere;
  away.translation().x() = 1e6;
  EXPECT_THROW(volume.integrate(wall(1), {}, kCamera, away), Error);
}

// The loop is closed with the truth: what is synthesized, written, read and fused lies on the room.
TEST(Fusion, SynthesizedFramesGiveTheRoomBack) {
  const TemporaryFolder folder;
  SynthesisOptions options;
  options.random_seed = 3;
  options.points = 400'000;
  const SynthesizedScene room = write_sequence(options, 24, folder / "s");
  const Sequence sequence(folder / "s", {.max_depth = 4});
  ASSERT_EQ(sequence.size(), 24u);
  const PointCloud map = fuse(sequence, {.voxel_size = 0.02}).points();
  EXPECT_GT(map.size(), 30'000u);
  EXPECT_TRUE(map.has_colors());
  const NearestLabels nearest = nearest_labels(room.cloud, map, 0.1);
  EXPECT_LT(nearest.mean_distance, 0.02);
  EXPECT_LT(static_cast<double>(nearest.beyond), 0.01 * static_cast<double>(map.size()));
}

}  // namespace
}  // namespace planescope
