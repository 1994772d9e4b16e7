// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

  int across() const { return across_; }
  int down() const { return down_; }
  bool parallel() const { return parallel_; }

  /// [pixel] Where a point is seen, from the lower left corner, and its depth [m].
  Eigen::Vector2f place(const Eigen::Vector3f& point, float& depth) const {
    const Eigen::Vector3d p = point.cast<double>() - position_;
    const double z = p.dot(forward_), scale = parallel_ ? 1 : 1 / z;
    depth = static_cast<float>(z);
    return Eigen::Vector2d(p.dot(right_) * scale + across_ / 2.0, p.dot(up_) * scale + down_ / 2.0)
        .cast<float>();
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

namespace {

/// Which splat is nearest at the middle of each pixel.
class SplatBuffer {
 public:
  explicit SplatBuffer(const Projector& projector)
      : across_(projector.across()),
        down_(projector.down()),
        depths_(projector.pixels(), std::numeric_limits<float>::infinity()),
        nearest_(projector.pixels(), kNobody) {}

  void add(const Eigen::Vector2f& place, float pixels, float depth, SplatShape shape,
           std::uint32_t index) {
    const float half = pixels / 2;
    const auto first = [&](float from) {
      return std::max(0, static_cast<int>(std::ceil(from - half - 0.5F)));
    };
    const auto end = [&](float to, int count) {
      return std::min(count, static_cast<int>(std::ceil(to + half - 0.5F)));
    };
    const int right = end(place.x(), across_), top = end(place.y(), down_);
    for (int y = first(place.y()); y < top; ++y) {
      for (int x = first(place.x()); x < right; ++x) {
        const float dx = static_cast<float>(x) + 0.5F - place.x();
        const float dy = static_cast<float>(y) + 0.5F - place.y();
        if (shape == SplatShape::Disc && dx * dx + dy * dy > half * half) continue;
        const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) +
                                  static_cast<std::size_t>(x);
        if (!(depth < depths_[pixel])) continue;
        depths_[pixel] = depth;
        nearest_[pixel] = index;
      }
    }
  }

  std::vector<std::uint32_t> seen() {
    std::erase(nearest_, kNobody);
    std::sort(nearest_.begin(), nearest_.end());
    nearest_.erase(std::unique(nearest_.begin(), nearest_.end()), nearest_.end());
    return std::move(nearest_);
  }

 private:
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
  int across_, down_;
  std::vector<float> depths_;
  std::vector<std::uint32_t> nearest_;
};

}  // namespace

std::vector<std::uint32_t> seen_splats(const PointCloud& cloud,
                                       const std::vector<std::uint32_t>& indices,
                                       const std::vector<float>& diameters, const PointScale& scale,
                                       const Camera& camera, int width, int height, double margin) {
  const Projector projector(camera, width, height, margin);
  SplatBuffer buffer(projector);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    float depth = 0;
    const Eigen::Vector2f place = projector.place(cloud.positions[indices[i]], depth);
    if (!(depth > 0)) continue;
    const float pixels = scale.pixels(diameters[i], projector.parallel() ? 1.0F : depth);
    const bool near =
        place.x() > -pixels && place.x() < static_cast<float>(projector.across()) + pixels &&
        place.y() > -pixels && place.y() < static_cast<float>(projector.down()) + pixels;
    if (near) buffer.add(place, pixels, depth, scale.shape, indices[i]);
  }
  return buffer.seen();
}

}  // namespace planescope::draw
