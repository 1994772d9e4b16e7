// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "patches/voxel_normals.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

// How often each voxel counts in m + S(m) + S(S(m)) around v, by going there.
std::vector<double> two_ring_weights(const VoxelGrid& grid, std::size_t v) {
  const auto around = [&](std::size_t i) {
    std::vector<std::size_t> voxels = {i};
    for (std::size_t k = grid.neighbour_offsets[i]; k < grid.neighbour_offsets[i + 1]; ++k)
      voxels.push_back(grid.neighbours[k]);
    return voxels;
  };
  std::vector<double> weight(grid.voxel_count(), 0);
  weight[v] += 1;
  for (const std::size_t near : around(v)) {
    weight[near] += 1;
    for (const std::size_t next : around(near)) weight[next] += 1;
  }
  return weight;
}

// The principal components of those voxels, in double precision by Eigen's iterative solver.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> components(const VoxelGrid& grid, std::size_t v) {
  const std::vector<double> weight = two_ring_weights(grid, v);
  double sum = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < weight.size(); ++i) {
    sum += weight[i];
    mean += weight[i] * grid.mean[i].cast<double>();
  }
  mean /= sum;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const Eigen::Vector3d d = grid.mean[i].cast<double>() - mean;
    covariance += weight[i] / sum * d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance);
}

double degrees_apart(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / std::numbers::pi;
}

TEST(VoxelNormals, AgreeWithPrincipalComponentsOfTwoRings) {
  testing::Uniform uniform(5);
  PointCloud cloud = testing::make_box_room(300);
  for (Eigen::Vector3f& p : cloud.positions)  // noise of 2 cm, a room far from the origin
    p += 0.04f * Eigen::Vector3f(uniform(), uniform(), uniform()) + Eigen::Vector3f(40, -70, 5);
  const VoxelGrid grid = make_voxel_grid(cloud, 0.1, false);
  const std::vector<Eigen::Vector3f> normals = estimate_voxel_normals(grid, grid.mean);
  std::size_t compared = 0;
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    EXPECT_NEAR(normals[v].norm(), 1, 1e-5);
    const auto pca = components(grid, v);
    const Eigen::Vector3d l = pca.eigenvalues() / pca.eigenvalues().sum();
    if (l[1] - l[0] < 0.02) continue;  // the normal is anyone's guess
    EXPECT_LT(degrees_apart(normals[v].cast<double>(), pca.eigenvectors().col(0)), 0.02)
        << "eigenvalues " << l.transpose();
    ++compared;
  }
  EXPECT_GT(compared, grid.voxel_count() / 2);
}

TEST(VoxelNormals, OfLinesPairsAndSinglePointsAreLegal) {
  PointCloud cloud;
  for (int i = 0; i < 40; ++i) cloud.positions.emplace_back(0.1f * float(i) + 0.05f, 0.05f, 0.05f);
  cloud.positions.emplace_back(0.05f, 5.0f, 0.05f);  // alone
  cloud.positions.emplace_back(0.05f, 9.0f, 0.05f);  // two in adjacent cells
  cloud.positions.emplace_back(0.15f, 9.0f, 0.05f);
  const VoxelGrid grid = make_voxel_grid(cloud, 0.1, false);
  const std::vector<Eigen::Vector3f> normals = estimate_voxel_normals(grid, grid.mean);
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    EXPECT_NEAR(normals[v].norm(), 1, 1e-5);
    const bool on_line = grid.mean[v].y() < 1;
    if (on_line) {
      EXPECT_NEAR(normals[v].x(), 0, 1e-3);  // orthogonal to the line
    } else if (grid.neighbour_offsets[v] == grid.neighbour_offsets[v + 1]) {
      EXPECT_EQ(normals[v], Eigen::Vector3f::UnitZ());
    }
  }
}

}  // namespace
}  // namespace planescope
