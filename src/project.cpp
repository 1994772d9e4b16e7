// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/project.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "planescope/error.hpp"

namespace planescope {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;
constexpr std::uint32_t kMostRadius = 64;

void check(const PointCloud& cloud, std::size_t labels, const PinholeCamera& camera,
           std::uint32_t radius) {
  if (labels != cloud.size()) {
    throw Error(Error::Kind::Input, "projection: " + std::to_string(labels) + " labels for " +
                                        std::to_string(cloud.size()) +
                                        " points; expected one a point");
  }
  const std::uint64_t pixels = std::uint64_t{camera.width} * camera.height;
  if (pixels == 0 || pixels > kMostPixels || radius > kMostRadius ||
      !(camera.fx > 0 && camera.fy > 0 && std::isfinite(camera.fx * camera.fy))) {
    throw Error(Error::Kind::Usage,
                "projection: expected 1 to 2^28 pixels, positive focal lengths and a radius of at "
                "most 64 pixels");
  }
}

/// A label image that remembers how near each pixel's point is.
class DepthBuffer {
 public:
  explicit DepthBuffer(const PinholeCamera& camera)
      : width_(camera.width),
        height_(camera.height),
        depth_(std::size_t{camera.width} * camera.height, std::numeric_limits<double>::infinity()),
        label_(depth_.size(), kNoSegment) {}

  void put(double column, double row, double depth, std::uint32_t label, double radius) {
    const auto clamped = [](double x, std::int64_t size) {
      return static_cast<std::int64_t>(std::clamp(x, -1.0, static_cast<double>(size)));
    };
    const std::int64_t left = std::max<std::int64_t>(0, clamped(column - radius, width_));
    const std::int64_t top = std::max<std::int64_t>(0, clamped(row - radius, height_));
    const std::int64_t right = std::min<std::int64_t>(width_ - 1, clamped(column + radius, width_));
    const std::int64_t bottom = std::min<std::int64_t>(height_ - 1, clamped(row + radius, height_));
    for (std::int64_t y = top; y <= bottom; ++y) {
      for (std::int64_t x = left; x <= right; ++x) {
        const auto pixel = static_cast<std::size_t>(y * width_ + x);
        if (!(depth < depth_[pixel])) continue;
        depth_[pixel] = depth;
        label_[pixel] = label;
      }
    }
  }

  std::vector<std::uint32_t> labels() && { return std::move(label_); }

 private:
  std::int64_t width_, height_;
  std::vector<double> depth_;
  std::vector<std::uint32_t> label_;
};

}  // namespace

std::vector<std::uint32_t> project_labels(const PointCloud& cloud,
                                          std::span<const std::uint32_t> labels,
                                          const PinholeCamera& camera, std::uint32_t radius) {
  check(cloud, labels.size(), camera, radius);
  const Eigen::Isometry3d to_camera = camera.pose.inverse();
  DepthBuffer buffer(camera);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.positions[i])) continue;
    const Eigen::Vector3d p = to_camera * (cloud.origin + cloud.positions[i].cast<double>());
    if (!(p.z() > 0)) continue;
    buffer.put(std::round(camera.fx * p.x() / p.z() + camera.cx),
               std::round(camera.fy * p.y() / p.z() + camera.cy), p.z(), labels[i], radius);
  }
  return std::move(buffer).labels();
}

}  // namespace planescope
