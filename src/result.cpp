// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/result.hpp"

#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "result_hash.hpp"
#include "result_json.hpp"
#include "result_points.hpp"

namespace planescope {

Result make_result(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input) {
  Result result;
  result.cloud = cloud;
  result.cloud.normals.clear();  // the folder does not keep them, and the two views are the same
  result.cloud.labels.clear();
  result.has_colors = cloud.has_colors();
  result.point_label = scene.point_label;
  result.point_plane = scene.point_plane;
  result.point_patch = scene.graph.point_patch;
  result.planes = scene.planes;
  result.segments = scene.segments.segments;
  result.up = scene_up(scene, cloud);
  const auto counts = count_rules(scene.edges);
  result.rule_counts.assign(counts.begin(), counts.end());
  result.patch_count = scene.graph.patches.size();
  result.input_name = input.name;
  result.voxel_size = scene.options.patches.voxel_size;
  result.patch_size = scene.options.patches.patch_size;
  return result;
}

void save(const Segmentation& scene, const PointCloud& cloud, const std::filesystem::path& folder,
          const InputInfo& input) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (!std::filesystem::is_directory(folder)) {
    throw Error(Error::Kind::Input, folder.string() + ": the folder cannot be made" +
                                        (failure ? ": " + failure.message() : "") +
                                        "; name another");
  }
  const std::string points =
      points_pcd({cloud, scene.point_label, scene.point_plane, scene.graph.point_patch});
  FileHash hash;
  hash.add(points);
  const std::string json = result_json(scene, cloud, input, hash.hex());
  write_whole(folder / "points.pcd", points);
  write_whole(folder / "result.json", json);  // last: a folder that has it is complete
}

}  // namespace planescope
