// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "io/pcd_reader.hpp"
#include "json_file.hpp"
#include "planescope/error.hpp"
#include "planescope/result.hpp"
#include "result_node.hpp"

/// \file load_result(): someone may have edited the folder, so nothing in it is believed.
namespace planescope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kHint = "run `planescope segment` again";

MethodInfo read_method(const Node& node) {
  MethodInfo method{node["name"].text(), true, true, {}};
  for (const Node& lack : node["lacks"].items()) {
    const std::string what = lack.text();
    if (what != "planes" && what != "graph") lack.fail("`planes` or `graph`");
    (what == "planes" ? method.has_planes : method.has_graph) = false;
  }
  for (const auto& [name, value] : node["settings"].members()) {
    method.settings.emplace_back(name, value.number());
  }
  return method;
}

void read_input(const Node& input, Result& result) {
  PointCloud& cloud = result.cloud;
  result.input_name = input["name"].text();
  result.input_hash = input["hash"].text();
  result.has_colors = input["has_color"].flag();
  cloud.width = input["width"].count();
  cloud.height = input["height"].count();
  cloud.origin = input["origin"].vector();
  if (!input["sensor"].null()) cloud.sensor = input["sensor"].position();
  if (std::uint64_t{cloud.width} * cloud.height != input["points"].count()) {
    input["points"].fail("width x height");
  }
}

SupportingPlane read_plane(const Node& node, std::size_t index) {
  if (node["id"].count() != index) node["id"].fail(std::to_string(index));
  SupportingPlane plane;
  plane.plane = {node["normal"].unit(), node["distance"].real()};
  const std::string role = node["role"].text();
  if (role != "support" && role != "face") node["role"].fail("support or face");
  plane.role = role == "face" ? PlaneRole::Face : PlaneRole::Support;
  if (plane.role == PlaneRole::Support) plane.hypothesis = node["hypothesis"].count();
  plane.patch_count = node["patches"].count();
  plane.point_count = node["points"].count();
  plane.area = node["area"].real();
  plane.rms = node["rms"].real();
  return plane;
}

Segment read_segment(const Node& node, std::size_t index, std::size_t planes) {
  if (node["label"].count() != index + 1) node["label"].fail(std::to_string(index + 1));
  Segment segment;
  segment.label = node["label"].count();
  if (!node["plane"].null()) {
    if (planes == 0) node["plane"].fail("null: there is no plane");
    const auto last = static_cast<std::uint32_t>(planes - 1);
    segment.plane = static_cast<std::int32_t>(node["plane"].count(last));
  }
  segment.patch_count = node["patches"].count();
  segment.point_count = node["points"].count();
  segment.area = node["area"].real();
  segment.centroid = node["centroid"].position();
  return segment;
}

void read_json(const Node& root, Result& result) {
  if (root["schema"].count() != static_cast<std::uint32_t>(kResultSchema)) {
    root["schema"].fail(std::to_string(kResultSchema) + ", which this planescope reads");
  }
  result.method = read_method(root["method"]);
  read_input(root["input"], result);
  result.voxel_size = root["options"]["patches.voxel_size"].number();
  result.patch_size = root["options"]["patches.patch_size"].number();
  if (!(result.voxel_size > 0)) root["options"]["patches.voxel_size"].fail("more than 0");
  if (!(result.patch_size > 0)) root["options"]["patches.patch_size"].fail("more than 0");
  result.options = read_options(root["options"]);
  result.up = root["up"].unit();
  result.patch_count = root["patches"].count();
  for (const Node& node : root["planes"].items()) {
    result.planes.push_back(read_plane(node, result.planes.size()));
  }
  if (!root["hypotheses"].null()) result.selection = read_selection(root["hypotheses"]);
  for (const Node& node : root["segments"].items()) {
    result.segments.push_back(read_segment(node, result.segments.size(), result.planes.size()));
  }
  if (root.has("files")) {
    for (const auto& [name, hash] : root["files"].members()) result.file_hashes[name] = hash.text();
  }
  for (std::size_t rule = 0; rule < kEdgeRuleCount; ++rule) {
    const std::string key(name(static_cast<EdgeRule>(rule)));
    result.rule_counts.push_back(root["edges"]["by_rule"][key.c_str()].count());
  }
}

/// The same origin as in the run, because planes are relative to it.
void read_points(const fs::path& file, Result& result) {
  auto [cloud, columns] = io::read_pcd_columns(file, {"plane", "patch"}, result.cloud.origin);
  if (cloud.width != result.cloud.width || cloud.height != result.cloud.height ||
      !cloud.has_labels()) {
    throw Error(Error::Kind::Input, file.string() +
                                        ": not the points that result.json beside it tells of; run "
                                        "`planescope segment` again");
  }
  result.cloud.positions = std::move(cloud.positions);
  if (result.has_colors) result.cloud.colors = std::move(cloud.colors);
  result.point_label = std::move(cloud.labels);
  result.point_plane = std::move(columns[0]);
  result.point_patch = std::move(columns[1]);
}

/// Labels, planes and patches of points must be ones that result.json knows.
void check_points(const Result& result, const fs::path& file) {
  const auto in_range = [](std::int32_t index, std::size_t size) {
    return index >= kNone && index < static_cast<std::int64_t>(size);
  };
  for (std::size_t i = 0; i < result.cloud.size(); ++i) {
    const bool labelled = result.point_label[i] != kNoSegment;
    if (result.point_label[i] > result.segments.size() ||
        !in_range(result.point_plane[i], result.planes.size()) ||
        !in_range(result.point_patch[i], result.patch_count) ||
        (labelled && !is_finite(result.cloud.positions[i]))) {
      throw Error(Error::Kind::Input, file.string() + ": point " + std::to_string(i) +
                                          " has a label, plane or patch that result.json does not "
                                          "know; run `planescope segment` again");
    }
  }
}

void check_hash(const fs::path& file, const std::string& expected) {
  if (hash_file(file) == expected) return;
  throw Error(Error::Kind::Input, file.string() +
                                      ": not the file that result.json beside it was written "
                                      "with; " +
                                      kHint);
}

}  // namespace

void check_file(const Result& result, const fs::path& folder, const std::string& name) {
  const auto known = result.file_hashes.find(name);
  if (known != result.file_hashes.end()) check_hash(folder / name, known->second);
}

Result load_result(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw Error(Error::Kind::Input, folder.string() +
                                        ": not a folder; name one that `planescope segment -o` "
                                        "made");
  }
  const fs::path json_file = folder / "result.json", points_file = folder / "points.pcd";
  const Json json = read_json(json_file, kHint);
  const Node root(json, json_file, "");
  Result result;
  result.options_hash = hash_text(root["options"].dump());
  read_json(root, result);
  auto points = std::async(std::launch::async, [&] { read_points(points_file, result); });
  check_hash(points_file, root["points_hash"].text());
  points.get();
  check_points(result, points_file);
  return result;
}

}  // namespace planescope
