// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/result.hpp"

#include "io/pcd_writer.hpp"
#include "io/whole_file.hpp"
#include "json_file.hpp"
#include "planescope/error.hpp"
#include "result_json.hpp"

namespace planescope {
namespace {

/// `x y z rgb label plane patch`: always these, so that scripts can rely on them; rgb is 0 where
/// the input has no colours (result.json says so).
void write_points(const Segmentation& scene, const PointCloud& cloud,
                  const std::filesystem::path& file) {
  PointCloud points = cloud;
  points.normals.clear();
  points.radii.clear();
  points.confidences.clear();
  points.labels = scene.point_label;
  points.colors.resize(cloud.size());
  io::write_pcd(file, points, CloudEncoding::Binary,
                {{"plane", std::span<const std::int32_t>(scene.point_plane)},
                 {"patch", std::span<const std::int32_t>(scene.graph.point_patch)}});
}

}  // namespace

Result make_result(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input) {
  Result result;
  result.method = scene.method;
  result.cloud = cloud;
  result.cloud.normals.clear();  // the folder does not keep them, and the two views are the same
  result.cloud.radii.clear();
  result.cloud.confidences.clear();
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
  result.input_hash = input.hash;
  result.options_hash = options_hash(scene.options, scene.method);
  result.voxel_size = scene.options.patches.voxel_size;
  result.patch_size = scene.options.patches.patch_size;
  result.options = scene.options;
  result.selection = scene.selection;
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
  const auto points_file = folder / "points.pcd", json_file = folder / "result.json";
  std::filesystem::remove(json_file, failure);  // a folder that has it is complete
  write_points(scene, cloud, points_file);
  write_whole(json_file, result_json(scene, cloud, input, hash_file(points_file)));
}

void add_files(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  const auto file = folder / "result.json";
  std::map<std::string, std::string> hashes;
  for (const std::string& name : names) hashes[name] = hash_file(folder / name);
  write_whole(file, with_files(read_json_text(file, "save() writes it"), hashes));
}

}  // namespace planescope
