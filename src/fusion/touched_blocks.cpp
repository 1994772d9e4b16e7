// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fusion/touched_blocks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "fusion/voxel_field.hpp"
#include "planescope/error.hpp"

namespace planescope::fusion {
namespace {

constexpr std::uint32_t kStride = 2;  // [pixel] at 6 m neighbours are 2 cm apart, blocks larger
constexpr std::uint32_t kBand = 16;   // [row] that one task walks

// Walks the pixels of some rows; keeps each key once, but for repeats that are far apart.
class Walker {
 public:
  Walker(const RangeImage& image, const Eigen::Isometry3d& pose, double voxel_size,
         double truncation)
      : image_(image),
        pose_(pose),
        per_block_(1 / (kSide * voxel_size)),
        truncation_(truncation),
        // Half a block apart at most, so that no block is stepped over but at its corners.
        steps_(1 + static_cast<int>(std::ceil(2 * truncation / (kSide * voxel_size / 2)))),
        last_(static_cast<std::size_t>(steps_), ~std::uint64_t{0}) {}

  void walk(std::uint32_t first_row, std::uint32_t end_row, std::vector<std::uint64_t>& keys) {
    for (std::uint32_t y = first_row; y < end_row; y += kStride) {
      for (std::uint32_t x = 0; x < image_.lens.width; x += kStride) visit(x, y, keys);
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  }

 private:
  void visit(std::uint32_t x, std::uint32_t y, std::vector<std::uint64_t>& keys) {
    const PinholeCamera& lens = image_.lens;
    const auto z = static_cast<double>(image_.depth[std::size_t{y} * lens.width + x]);
    if (z == 0) return;
    const Eigen::Vector3d ray((x - lens.cx) / lens.fx, (y - lens.cy) / lens.fy, 1);
    const double reach = truncation_ / ray.norm();  // along z
    const Eigen::Vector3d near = pose_ * ((z - reach) * ray) * per_block_;
    const Eigen::Vector3d step = pose_.linear() * (2 * reach / (steps_ - 1) * ray) * per_block_;
    for (int s = 0; s < steps_; ++s) {
      const std::uint64_t key = key_of(near + s * step);
      std::uint64_t& last = last_[static_cast<std::size_t>(s)];
      if (key != last) keys.push_back(last = key);
    }
  }

  static std::uint64_t key_of(const Eigen::Vector3d& block) {
    if (!(block.cwiseAbs().maxCoeff() < kReach - 1)) {
      throw Error(Error::Kind::Computation,
                  "fusion: a frame lies a million blocks of voxels away from the first one; is its "
                  "pose right, and the voxel size?");
    }
    const auto part = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
    return pack({part(block.x()), part(block.y()), part(block.z())});
  }

  const RangeImage& image_;
  const Eigen::Isometry3d& pose_;
  double per_block_, truncation_;
  int steps_;
  std::vector<std::uint64_t> last_;  // per step along the ray: the key before
};

}  // namespace

std::vector<std::uint64_t> find_touched_blocks(const RangeImage& image,
                                               const Eigen::Isometry3d& pose, double voxel_size,
                                               double truncation) {
  const std::uint32_t height = image.lens.height;
  std::vector<std::vector<std::uint64_t>> bands((height + kBand - 1) / kBand);
  tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t b) {
    const auto first = static_cast<std::uint32_t>(b) * kBand;
    Walker(image, pose, voxel_size, truncation)
        .walk(first, std::min(first + kBand, height), bands[b]);
  });
  std::vector<std::uint64_t> keys;
  for (const auto& band : bands) keys.insert(keys.end(), band.begin(), band.end());
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

}  // namespace planescope::fusion
