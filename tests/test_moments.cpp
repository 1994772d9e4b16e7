// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "patches/moments.hpp"
#include "toy_clouds.hpp"

namespace planescope {
namespace {

using testing::Uniform;

Eigen::Vector3f random_point(Uniform& uniform) {
  return {uniform() - 0.5f, uniform() - 0.5f, uniform() - 0.5f};
}

TEST(PrincipalPlane, AgreesWithEigensIterativeSolver) {
  Uniform uniform(11);
  for (int trial = 0; trial < 500; ++trial) {
    const Eigen::Vector3f stretch(1.0f, 0.2f + 0.8f * uniform(), 0.02f + 0.15f * uniform());
    Moments moments;
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    Eigen::Vector3d first = Eigen::Vector3d::Zero();
    for (int i = 0; i < 30; ++i) {
      Eigen::Vector3f q = random_point(uniform).cwiseProduct(stretch);
      q = Eigen::Vector3f(0.6f * q.x() - 0.8f * q.z(), q.y(), 0.8f * q.x() + 0.6f * q.z());
      moments.add(q);
      first += q.cast<double>();
      second += q.cast<double>() * q.cast<double>().transpose();
    }
    const Eigen::Vector3d mean = first / 30;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(second / 30 -
                                                                mean * mean.transpose());
    const PrincipalPlane plane = principal_plane(moments);
    EXPECT_NEAR(std::abs(plane.normal.cast<double>().dot(solver.eigenvectors().col(0))), 1.0, 1e-5);
    EXPECT_NEAR(plane.curvature, solver.eigenvalues()[0] / solver.eigenvalues().sum(), 1e-5);
    EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-5);
  }
}

TEST(PrincipalPlane, DegenerateSetsAreLegal) {
  Moments two, same, line;
  for (int i = 0; i < 2; ++i) two.add(Eigen::Vector3f(float(i), 0, 0));
  for (int i = 0; i < 9; ++i) same.add(Eigen::Vector3f(1, 2, 3));
  for (int i = 0; i < 9; ++i) line.add(float(i) * Eigen::Vector3f(0.1f, 0, 0));
  EXPECT_EQ(principal_plane(two).curvature, 0);
  EXPECT_NEAR(principal_plane(same).normal.norm(), 1.0, 1e-5);
  EXPECT_NEAR(principal_plane(line).normal.norm(), 1.0, 1e-5);
  EXPECT_NEAR(principal_plane(line).normal.x(), 0.0, 1e-4);  // orthogonal to the line
}

}  // namespace
}  // namespace planescope
