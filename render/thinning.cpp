// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace planescope::draw {
namespace {

/// project() for many points: the camera's axes are worked out once.
class Projector {
 public:
  Projector(const Camera& camera, int width, int height, double margin)
      : position_(camera.position),
        forward_(camera.forward()),
        across_(width + 2 * static_cast<int>(margin * width)),
        down_(height + 2 * static_cast<int>(margin * height)),
        parallel_(camera.parallel()) {
    const double pixels = pixels_per_metre(camera, height, 1);
    right_ = camera.right() * pixels;
    up_ = camera.up * pixels;
  }

  std::size_t pixels() const {
    return static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_);
  }

  /// The pixel of a point, or pixels() where it is not seen; and its depth.
  std::size_t pixel(const Eigen::Vector3f& point, float& depth) const {
    const Eigen::Vector3d p = point.cast<double>() - position_;
    const double z = p.dot(forward_);
    depth = static_cast<float>(z);
    if (!(z > 0)) return pixels();
    const double scale = parallel_ ? 1 : 1 / z;
    const double x = std::floor(p.dot(right_) * scale + across_ / 2.0);
    const double y = std::floor(p.dot(up_) * scale + down_ / 2.0);
    if (!(x >= 0 && x < across_ && y >= 0 && y < down_)) return pixels();
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) +
           static_cast<std::size_t>(x);
  }

 private:
  Eigen::Vector3d position_, forward_, right_, up_;
  int across_, down_;
  bool parallel_;
};

}  // namespace

std::vector<std::uint32_t> nearest_per_pixel(const PointCloud& cloud,
                                             const std::vector<std::uint32_t>& indices,
                                             const Camera& camera, int width, int height,
                                             double margin) {
  constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
  const Projector projector(camera, width, height, margin);
  std::vector<float> depths(projector.pixels(), std::numeric_limits<float>::infinity());
  std::vector<std::uint32_t> nearest(projector.pixels(), kNobody);
  for (const std::uint32_t index : indices) {
    float depth = 0;
    const std::size_t pixel = projector.pixel(cloud.positions[index], depth);
    if (pixel == projector.pixels() || !(depth < depths[pixel])) continue;
    depths[pixel] = depth;
    nearest[pixel] = index;
  }
  std::erase(nearest, kNobody);
  std::sort(nearest.begin(), nearest.end());
  return nearest;
}

}  // namespace planescope::draw
