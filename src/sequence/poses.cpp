// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "sequence/layouts.hpp"

namespace planescope::sequence {

std::optional<Eigen::Isometry3d> make_rigid(const Eigen::Matrix4d& matrix, double tolerance) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const Eigen::Matrix3d deviation = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  const Eigen::RowVector4d last(0, 0, 0, 1);
  const bool rigid = deviation.cwiseAbs().maxCoeff() <= tolerance && rotation.determinant() > 0 &&
                     (matrix.row(3) - last).cwiseAbs().maxCoeff() <= tolerance &&
                     matrix.topRightCorner<3, 1>().cwiseAbs().maxCoeff() <= 1e7;
  if (!rigid) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = matrix.topRightCorner<3, 1>();
  pose.linear() = rotation;  // as it is where it is one: what write_trajectory() wrote comes back
  if (deviation.cwiseAbs().maxCoeff() <= 1e-12) return pose;
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  return pose;
}

std::optional<Eigen::Isometry3d> read_matrix(TextLines& lines) {
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    if (!lines.next()) {
      lines.file().fail("ends after " + std::to_string(row) +
                        " of the 4 lines of a pose; expected a matrix of 4 x 4 numbers");
    }
    lines.require(4, "4 numbers: a row of the matrix camera to world");
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = lines.number(static_cast<std::size_t>(column));
    }
  }
  if (!matrix.allFinite()) return std::nullopt;
  std::optional<Eigen::Isometry3d> pose = make_rigid(matrix);
  if (!pose) {
    lines.fail(
        "the pose that ends here is no rotation and translation (within 1e7 m); expected a "
        "matrix camera to world");
  }
  return pose;
}

}  // namespace planescope::sequence
