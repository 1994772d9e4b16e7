// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_json.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace planescope {
namespace {

using Json = nlohmann::ordered_json;

/// A float as the double with the same shortest text: 0.1f is written 0.1, not 0.10000000149.
double tidy(float value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  double exact = 0;
  std::from_chars(buffer, end, exact);
  return exact;
}

template <class Vector>
Json vector(const Vector& v) {
  if constexpr (std::is_same_v<typename Vector::Scalar, float>) {
    return {tidy(v.x()), tidy(v.y()), tidy(v.z())};
  } else {
    return {v.x(), v.y(), v.z()};
  }
}

Json index_or_null(std::int32_t index) { return index == kNone ? Json() : Json(index); }

Json input_json(const PointCloud& cloud, const InputInfo& input, std::size_t strays) {
  const auto finite = std::ranges::count_if(cloud.positions, is_finite);
  Json all = {{"name", input.name},
              {"hash", input.hash},
              {"points", cloud.size()},
              {"finite_points", finite},
              {"width", cloud.width},
              {"height", cloud.height},
              {"origin", vector(cloud.origin)},
              {"sensor", cloud.sensor ? vector(*cloud.sensor) : Json()},
              {"has_color", cloud.has_colors()}};
  if (strays > 0) all["stray_points"] = strays;  // rare: left out, far away from all others
  return all;
}

/// What a method lacks is said, so that no plane and no notion of planes are told apart.
Json method_json(const MethodInfo& method) {
  Json lacks = Json::array(), settings = Json::object();
  if (!method.has_planes) lacks.push_back("planes");
  if (!method.has_graph) lacks.push_back("graph");
  for (const auto& [name, value] : method.settings) settings[name] = value;
  return {{"name", method.name}, {"lacks", std::move(lacks)}, {"settings", std::move(settings)}};
}

/// Of a peer only the scale: its other options are settings of the method.
Json options_json(const Options& options, const MethodInfo& method) {
  Json all = Json::object();
  for (const OptionInfo& info : option_table()) {
    const bool scale = info.name == "patches.voxel_size" || info.name == "patches.patch_size";
    if (!method.is_ours() && !scale) continue;
    const std::string text = get_option(options, info.name);
    all[info.name] = info.unit == "choice" ? Json(text) : Json::parse(text);
  }
  return all;
}

Json scale_json(const PointCloud& cloud) {
  const CloudScale scale = measure_scale(cloud);
  return {{"spacing", scale.spacing}, {"noise", scale.noise}, {"extent", vector(scale.extent)}};
}

Json planes_json(const Segmentation& scene) {
  Json all = Json::array();
  for (const SupportingPlane& plane : scene.planes) {
    const bool face = plane.role == PlaneRole::Face;
    all.push_back({{"id", all.size()},
                   {"role", face ? "face" : "support"},
                   {"normal", vector(plane.plane.normal)},
                   {"distance", tidy(plane.plane.distance)},
                   {"area", tidy(plane.area)},
                   {"patches", plane.patch_count},
                   {"points", plane.point_count},
                   {"rms", tidy(plane.rms)},
                   {"hypothesis", face ? Json() : Json(plane.hypothesis)}});
  }
  return all;
}

Json rejected_json(const PlaneSelection& selection) {
  Json all = Json::array();
  for (std::size_t i = 0; i < selection.hypotheses.size(); ++i) {
    const PlaneHypothesis& h = selection.hypotheses[i];
    if (h.selected || h.inlier_count <= selection.lambda) continue;
    all.push_back({{"hypothesis", i},
                   {"normal", vector(h.plane.normal)},
                   {"distance", tidy(h.plane.distance)},
                   {"inliers", h.inlier_count},
                   {"area", tidy(h.inlier_area)},
                   {"data_cost", h.data_cost},
                   {"flip_cost", h.flip_cost},
                   {"blocked_by", index_or_null(h.blocked_by)},
                   {"angle_cost", h.blocked_angle_cost},
                   {"overlap_cost", h.blocked_overlap_cost}});
  }
  return all;
}

Json hypotheses_json(const PlaneSelection& selection) {
  return {{"proposed", selection.proposed}, {"entered", selection.hypotheses.size()},
          {"selected", selection.selected}, {"lambda", selection.lambda},
          {"energy", selection.energy},     {"rejected", rejected_json(selection)}};
}

Json segments_json(const Segmentation& scene) {
  Json all = Json::array();
  for (const Segment& segment : scene.segments.segments) {
    all.push_back({{"label", segment.label},
                   {"plane", index_or_null(segment.plane)},
                   {"patches", segment.patch_count},
                   {"points", segment.point_count},
                   {"area", tidy(segment.area)},
                   {"centroid", vector(segment.centroid)}});
  }
  return all;
}

Json edges_json(const std::vector<Edge>& edges) {
  const auto on = std::ranges::count(edges, true, &Edge::on);
  Json rules = Json::object();
  const auto counts = count_rules(edges);
  for (std::size_t rule = 0; rule < kEdgeRuleCount; ++rule) {
    rules[std::string(name(static_cast<EdgeRule>(rule)))] = counts[rule];
  }
  return {{"count", edges.size()},
          {"on", on},
          {"off", std::ssize(edges) - on},
          {"by_rule", std::move(rules)}};
}

bool holds_records(const Json& value) {
  return value.is_array() &&
         std::ranges::any_of(value, [](const Json& v) { return v.is_object(); });
}

/// One line a number, vector or record: short to read, and a diff of two results names the plane
/// that moved. File names need not be UTF-8; JSON must.
std::string lay_out(const Json& value, std::size_t depth = 0) {
  const bool broken = holds_records(value) || (value.is_object() && depth < 2);
  if (!broken) return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string indent(depth + 1, ' ');
  std::string out(1, value.is_object() ? '{' : '[');
  for (auto item = value.begin(); item != value.end(); ++item) {
    out += (item == value.begin() ? "\n" : ",\n") + indent;
    if (value.is_object()) out += Json(item.key()).dump() + ": ";
    out += lay_out(*item, depth + 1);
  }
  return out + "\n" + indent.substr(1) + (value.is_object() ? '}' : ']');
}

}  // namespace

std::string options_hash(const Options& options, const MethodInfo& method) {
  return hash_text(nlohmann::json(options_json(options, method)).dump());  // which sorts the keys
}

std::string with_files(const std::string& result_json,
                       const std::map<std::string, std::string>& hashes) {
  Json all = Json::parse(result_json);  // which we have just written
  all["files"] = hashes;
  return lay_out(all) + "\n";
}

std::string result_json(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input,
                        const std::string& points_hash) {
  const Json all = {
      {"schema", kResultSchema},
      {"planescope", PLANESCOPE_VERSION},
      {"input", input_json(cloud, input, scene.graph.stray_points)},
      {"method", method_json(scene.method)},
      {"options", options_json(scene.options, scene.method)},
      {"scale", scale_json(cloud)},
      {"up", vector(scene_up(scene, cloud))},
      {"patches", scene.graph.patches.size()},
      {"planes", planes_json(scene)},
      {"hypotheses", scene.method.is_ours() ? hypotheses_json(scene.selection) : Json()},
      {"segments", segments_json(scene)},
      {"edges", edges_json(scene.edges)},
      {"points_hash", points_hash}};
  return lay_out(all) + "\n";
}

}  // namespace planescope
