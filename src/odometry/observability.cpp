// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "odometry/observability.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>

namespace planescope::odometry {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

class View {
 public:
  View(const Frame& frame, const DepthCamera& camera) : frame_(frame), camera_(camera) {}

  /// The point that a pixel sees; z is 0 where it sees none. Of pixels up to `reach` away the mean
  /// depth, as far as they go on with this one: a far wall's noise is no relief.
  Vector3d point(std::uint32_t x, std::uint32_t y, std::uint32_t reach = 0) const {
    const PinholeCamera& lens = camera_.lens;
    const double here = depth(x, y);
    double sum = 0, count = 0;
    for (std::uint32_t v = y - std::min(y, reach); v <= y + reach && v < height(); ++v) {
      for (std::uint32_t u = x - std::min(x, reach); u <= x + reach && u < width(); ++u) {
        const double z = depth(u, v);
        if (!(z > 0) || std::abs(z - here) > 0.1 * here) continue;
        sum += z;
        count += 1;
      }
    }
    const double z = here > 0 ? sum / count : 0;
    return {(x - lens.cx) / lens.fx * z, (y - lens.cy) / lens.fy * z, z};
  }

  /// Of the surface, from pixels `base` away on all four sides; nothing at its ends and edges.
  std::optional<Vector3d> normal(std::uint32_t x, std::uint32_t y, std::uint32_t base) const {
    const std::uint32_t reach = base / 4;
    const Vector3d p = point(x, y, reach);
    const Vector3d left = point(x - base, y, reach), right = point(x + base, y, reach);
    const Vector3d above = point(x, y - base, reach), below = point(x, y + base, reach);
    const double jump = 0.1 * p.z();
    const auto goes_on = [&](const Vector3d& a, const Vector3d& b) {
      return a.z() > 0 && b.z() > 0 && std::abs(a.z() - b.z()) < 2 * jump &&
             std::abs(a.z() + b.z() - 2 * p.z()) < jump;
    };
    if (!(p.z() > 0) || !goes_on(left, right) || !goes_on(above, below)) return std::nullopt;
    return (right - left).cross(below - above).normalized();
  }

  /// Change of brightness by the camera's motion [1/m].
  Vector3d brightness_change(std::uint32_t x, std::uint32_t y) const {
    constexpr double kLeast = 0.02, kMost = 0.05;  // [1/pixel] noise below, few edges above
    const PinholeCamera& lens = camera_.lens;
    const Vector3d p = point(x, y);
    const Eigen::Vector2d gradient((brightness(x + 2, y) - brightness(x - 2, y)) / 4,
                                   (brightness(x, y + 2) - brightness(x, y - 2)) / 4);
    const double steepness = gradient.norm();
    if (!(p.z() > 0) || steepness < kLeast) return Vector3d::Zero();
    const double share = std::min(1.0, kMost / steepness);
    const double dx = share * gradient.x() * lens.fx / p.z();
    const double dy = share * gradient.y() * lens.fy / p.z();
    return {dx, dy, -(dx * p.x() + dy * p.y()) / p.z()};
  }

 private:
  std::size_t at(std::uint32_t x, std::uint32_t y) const {
    return std::size_t{y} * frame_.depth.width + x;
  }

  std::uint32_t width() const { return frame_.depth.width; }
  std::uint32_t height() const { return frame_.depth.height; }

  double depth(std::uint32_t x, std::uint32_t y) const {
    return camera_.depth(frame_.depth.values[at(x, y)]);
  }

  double brightness(std::uint32_t x, std::uint32_t y) const {
    return odometry::brightness(frame_.color.pixels[at(x, y)]);
  }

  const Frame& frame_;
  const DepthCamera& camera_;
};

double least_eigenvalue(const Matrix3d& sum, std::size_t count) {
  if (count == 0) return 0;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(sum, Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[0]) / static_cast<double>(count);
}

}  // namespace

Observability observe(const Frame& frame, const DepthCamera& camera) {
  const View view(frame, camera);
  const std::uint32_t width = frame.depth.width, height = frame.depth.height;
  const std::uint32_t base = std::max(2U, width / 40), step = std::max(1U, base / 2);
  Matrix3d normals = Matrix3d::Zero(), changes = Matrix3d::Zero();
  std::size_t count = 0;
  for (std::uint32_t y = base; y + base < height; y += step) {
    for (std::uint32_t x = base; x + base < width; x += step) {
      const std::optional<Vector3d> normal = view.normal(x, y, base);
      if (normal) normals += *normal * normal->transpose();
      count += normal ? 1 : 0;
      if (frame.color.empty()) continue;
      const Vector3d change = view.brightness_change(x, y);
      changes += change * change.transpose();
    }
  }
  return {least_eigenvalue(normals, count), least_eigenvalue(changes, count)};
}

}  // namespace planescope::odometry
