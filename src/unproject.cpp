// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <limits>
#include <string>

#include "planescope/error.hpp"
#include "planescope/sequence.hpp"

namespace planescope {

PointCloud unproject(const DepthImage& depth, const ColorImage& color, const DepthCamera& camera) {
  const PinholeCamera& lens = camera.lens;
  const std::size_t pixels = std::size_t{depth.width} * depth.height;
  const bool same = depth.width == lens.width && depth.height == lens.height &&
                    depth.size() == pixels && pixels > 0;
  const bool colored = !color.empty();
  if (!same || (colored && (color.width != depth.width || color.height != depth.height ||
                            color.pixels.size() != pixels))) {
    throw Error(Error::Kind::Usage, "unproject: depth is " + std::to_string(depth.width) + " x " +
                                        std::to_string(depth.height) +
                                        " pixels; expected camera and colour to be too");
  }
  PointCloud cloud;
  cloud.width = depth.width;
  cloud.height = depth.height;
  cloud.sensor = Eigen::Vector3f::Zero();
  if (colored) cloud.colors = color.pixels;
  cloud.positions.assign(pixels,
                         Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < depth.height; ++y) {
    for (std::uint32_t x = 0; x < depth.width; ++x, ++i) {
      const double z = camera.depth(depth.values[i]);
      if (z == 0) continue;
      cloud.positions[i] =
          Eigen::Vector3d((x - lens.cx) / lens.fx * z, (y - lens.cy) / lens.fy * z, z)
              .cast<float>();
    }
  }
  return cloud;
}

}  // namespace planescope
