// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "explain_json.hpp"

namespace planescope {
namespace {

using Json = nlohmann::ordered_json;

Json vector(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

Json index_or_null(std::int32_t index) { return index == kNone ? Json() : Json(index); }

Json patch_json(const PatchReport& r) {
  return {{"patch", r.id},
          {"centroid", vector(r.patch.centroid)},
          {"normal", vector(r.patch.normal)},
          {"curvature", r.patch.curvature},
          {"area", r.patch.area},
          {"points", r.patch.point_count},
          {"segment", r.segment},
          {"truth", r.truth == 0 ? Json() : Json(r.truth)},
          {"plane", index_or_null(r.plane)},
          {"plane_margin", r.margin},
          {"nearest_plane", index_or_null(r.nearest)},
          {"distance", r.nearest == kNone ? Json() : Json(r.distance)},
          {"distance_limit", r.distance_limit},
          {"normal_cosine", r.nearest == kNone ? Json() : Json(r.normal_cosine)}};
}

Json measures_json(const std::vector<Measure>& measures) {
  Json all = Json::array();
  for (const Measure& m : measures) {
    all.push_back({{"name", m.name},
                   {"unit", m.unit},
                   {"value", m.value},
                   {"threshold", m.threshold},
                   {"on", m.above ? "from" : "up_to"},
                   {"holds", m.holds},
                   {"decided", m.decided},
                   {"option", m.option.empty() ? Json() : Json(m.option)}});
  }
  return all;
}

Json flips_json(const std::vector<Flip>& flips, bool of_edge) {
  Json all = Json::array();
  for (const Flip& flip : flips) {
    Json settings = Json::array();
    for (const Setting& s : flip.settings)
      settings.push_back({{"option", s.option}, {"from", s.from}, {"to", s.to}});
    all.push_back({{"settings", std::move(settings)},
                   {"switched_on", flip.switched_on},
                   {"switched_off", flip.switched_off},
                   {"planes", flip.planes},
                   {"segments", flip.segments}});
    if (of_edge) all.back()["rule"] = name(flip.rule);
  }
  return all;
}

Json hypothesis_json(const PlaneHypothesis& h) {
  return {{"normal", vector(h.plane.normal)},
          {"distance", h.plane.distance},
          {"inliers", h.inlier_count},
          {"area", h.inlier_area},
          {"data_cost", h.data_cost}};
}

Json report_json(const HypothesisReport& r) {
  Json json = {{"hypothesis", r.index}};
  json.update(hypothesis_json(r.hypothesis));
  json["selected"] = r.hypothesis.selected;
  json["flip_cost"] = r.hypothesis.flip_cost;
  json["plane"] = index_or_null(r.plane);
  json["pairs"] = Json::array();
  for (const PairCost& pair : r.pairs) {
    json["pairs"].push_back({{"hypothesis", pair.hypothesis},
                             {"plane", index_or_null(pair.plane)},
                             {"angle", pair.angle},
                             {"angle_cost", pair.angle_cost},
                             {"overlap_cost", pair.overlap_cost}});
  }
  return json;
}

}  // namespace

Json to_json(const EdgeExplanation& x) {
  return {{"edge", {x.edge.first, x.edge.second}},
          {"index", x.index},
          {"state", x.edge.on ? "on" : "off"},
          {"rule", name(x.edge.rule)},
          {"margin", x.edge.margin},
          {"border", x.edge.border},
          {"truth", name(x.error)},
          {"words", x.words},
          {"measures", measures_json(x.measures)},
          {"patches", {patch_json(x.first), patch_json(x.second)}},
          {"flips", flips_json(x.flips, true)}};
}

Json to_json(const Chain& chain) {
  return {{"joined", chain.joined}, {"one_segment", chain.one_segment}, {"chain", chain.patches}};
}

Json to_json(const ErrorSummary& s) {
  Json edges = Json::object(), merged = Json::object(), cut = Json::object();
  Json points = Json::object();
  for (std::size_t i = 0; i < kEdgeErrorCount; ++i)
    edges[std::string(name(static_cast<EdgeError>(i)))] = s.edges[i];
  for (std::size_t i = 0; i < kEdgeRuleCount; ++i) {
    const std::string rule(name(static_cast<EdgeRule>(i)));
    if (s.merged_by_rule[i] > 0) merged[rule] = s.merged_by_rule[i];
    if (s.cut_by_rule[i] > 0) cut[rule] = s.cut_by_rule[i];
  }
  for (std::size_t i = 0; i < kPointErrorCount; ++i)
    points[std::string(name(static_cast<PointError>(i)))] = s.points[i];
  return {{"edge_errors", std::move(edges)},
          {"merged_by_rule", std::move(merged)},
          {"cut_by_rule", std::move(cut)},
          {"harmless_cuts", s.harmless_cuts},
          {"point_errors", std::move(points)}};
}

Json to_json(const PlaneExplanation& x) {
  Json beaten = Json::array(), truth = Json::array();
  for (const HypothesisReport& r : x.beaten) beaten.push_back(report_json(r));
  for (const ObjectShare& share : x.truth)
    truth.push_back({{"truth", share.truth}, {"points", share.points}});
  return {{"plane", x.index},
          {"role", x.plane.role == PlaneRole::Face ? "face" : "support"},
          {"normal", vector(x.plane.plane.normal)},
          {"distance", x.plane.plane.distance},
          {"patches", x.plane.patch_count},
          {"points", x.plane.point_count},
          {"area", x.plane.area},
          {"rms", x.plane.rms},
          {"lambda", x.lambda},
          {"chosen", report_json(x.chosen)},
          {"beaten", std::move(beaten)},
          {"truth", std::move(truth)},
          {"flips", flips_json(x.flips, false)}};
}

Json to_json(const MissingExplanation& x) {
  Json near = Json::array();
  for (std::size_t i = 0; i < x.near.size(); ++i) {
    near.push_back(report_json(x.near[i]));
    near.back()["holds_patch"] = static_cast<bool>(x.holds[i]);
  }
  return {{"place", vector(x.place)},
          {"distance", x.distance},
          {"nearest", patch_json(x.patch)},
          {"face", x.face == kNone ? Json() : Json(x.face)},
          {"lambda", x.lambda},
          {"local", x.local ? hypothesis_json(*x.local) : Json()},
          {"hypotheses", std::move(near)},
          {"flips", flips_json(x.flips, false)}};
}

}  // namespace planescope
