// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "planescope/synthesize.hpp"

namespace planescope::bench {

std::filesystem::path data_folder(const std::string& argument) {
  if (!argument.empty()) return argument;
  const char* place = std::getenv("PLANESCOPE_DATA");
  return place != nullptr ? place : std::filesystem::path(PLANESCOPE_SOURCE_DIR) / "../shared/data";
}

std::vector<std::filesystem::path> tabletop_views(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> views;
  std::error_code absent;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "mosd_learn", absent))
    if (entry.path().extension() == ".pcd") views.push_back(entry.path());
  std::sort(views.begin(), views.end());
  return views;
}

PointCloud room(std::uint64_t points, std::uint64_t random_seed) {
  SynthesisOptions options;
  options.points = points;
  options.random_seed = random_seed;
  return synthesize(options).cloud;
}

PointCloud tiled(const PointCloud& cloud, int columns, int rows) {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
  for (const Eigen::Vector3f& p : cloud.positions) {
    if (!is_finite(p)) continue;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3f pitch = high - low + Eigen::Vector3f::Ones();
  PointCloud result;
  result.origin = cloud.origin;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3f shift(static_cast<float>(column) * pitch.x(),
                                  static_cast<float>(row) * pitch.y(), 0);
      for (const Eigen::Vector3f& p : cloud.positions) result.positions.push_back(p + shift);
      result.colors.insert(result.colors.end(), cloud.colors.begin(), cloud.colors.end());
      result.normals.insert(result.normals.end(), cloud.normals.begin(), cloud.normals.end());
      result.labels.insert(result.labels.end(), cloud.labels.begin(), cloud.labels.end());
    }
  result.width = static_cast<std::uint32_t>(result.size());
  return result;
}

PointCloud as_depth_view(const PointCloud& view, PinholeCamera lens) {
  DepthCamera camera;
  DepthImage image{view.width, view.height, {}};
  for (const Eigen::Vector3f& p : view.positions) {
    const double depth = is_finite(p) ? std::round(double{p.z()} * camera.depth_scale) : 0;
    image.values.push_back(static_cast<std::uint16_t>(std::clamp(depth, 0.0, 65535.0)));
  }
  lens.width = view.width;
  lens.height = view.height;
  camera.lens = lens;
  return unproject(image, {view.width, view.height, view.colors}, camera);
}

Options room_options(double voxel_size, double patch_size) {
  Options options = Options::room();
  options.patches.voxel_size = voxel_size;
  options.patches.patch_size = patch_size;
  return options;
}

}  // namespace planescope::bench
