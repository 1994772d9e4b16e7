// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Geometry>

#include "patch_report.hpp"
#include "planescope/error.hpp"
#include "planescope/explain.hpp"
#include "what_if.hpp"

/// \file EdgeExplainer: the numbers of one edge, and what would flip it.
namespace planescope {
namespace {

bool by_planes(EdgeRule rule) {
  return rule == EdgeRule::SamePlane || rule == EdgeRule::DifferentPlanes ||
         rule == EdgeRule::PlaneBoundary;
}

Measure measure(std::string name, std::string unit, double value, double threshold, bool above,
                std::string option) {
  const bool holds = above ? value >= threshold : value < threshold;
  return {std::move(name), std::move(unit), value, threshold,
          above,           holds,           false, std::move(option)};
}

/// Distance and direction of a patch against a plane: both have to hold for it to lie there.
void add_plane_measures(std::vector<Measure>& all, const Segmentation& scene, const PatchReport& r,
                        std::int32_t index, bool decided) {
  const Plane& plane = scene.planes[static_cast<std::size_t>(index)].plane;
  const std::string of = " of " + std::to_string(r.id) + " to plane " + std::to_string(index);
  const double distance = std::abs(static_cast<double>(plane.signed_distance(r.patch.centroid)));
  const double cosine = std::abs(static_cast<double>(plane.normal.dot(r.patch.normal)));
  all.push_back(measure("distance" + of, "m", distance, r.distance_limit, false, "planes.sigma"));
  all.back().decided = decided;
  all.push_back(measure("|n . n_p|" + of, "", cosine, scene.options.planes.normal_gate, true,
                        "planes.normal_gate"));
  all.back().decided = decided;
}

/// Both patches against each plane that one of them lies on; where none does, against the nearest.
void add_planes(std::vector<Measure>& all, const Segmentation& scene, const EdgeExplanation& x) {
  const std::int32_t a = x.first.plane, b = x.second.plane;
  const bool decided = a != kNone || b != kNone;
  for (const PatchReport* r : {&x.first, &x.second}) {
    std::vector<std::int32_t> planes = {a, b};
    if (!decided) planes = {r->nearest};
    if (planes.size() == 2 && a == b) planes.pop_back();
    for (const std::int32_t plane : planes)
      if (plane != kNone) add_plane_measures(all, scene, *r, plane, decided);
  }
}

std::vector<Measure> measures_of(const Segmentation& scene, const EdgeExplanation& x) {
  const EdgeOptions& options = scene.options.edges;
  const Edge& e = x.edge;
  const auto is = [&](EdgeRule rule) { return e.rule == rule; };
  std::vector<Measure> all;
  add_planes(all, scene, x);
  if (!by_planes(e.rule) && static_cast<double>(e.normal_angle) > options.rim_angle) {
    // The two sides of a board, or two things that face each other: nothing else is asked.
    all.push_back(measure("facing distance", "m", e.facing, e.step_limit, false,
                          "edges.smoothness_tolerance"));
    all.back().holds = e.facing <= e.step_limit;
    all.back().decided = !is(EdgeRule::NoSupport);
    all.push_back(measure("angle of the normals (rim)", "deg", e.normal_angle, options.rim_angle,
                          true, "edges.rim_angle"));
    return all;
  }
  all.push_back(measure("angle to the fold", "deg", e.singular_angle, e.singular_limit, true,
                        "edges.singular_angle"));
  all.back().decided = is(EdgeRule::Singular);
  all.push_back(measure("step", "m", e.step, e.step_limit, false, "edges.smoothness_tolerance"));
  all.back().holds = e.step <= e.step_limit;
  all.back().decided = is(EdgeRule::Step);
  const bool convex = is(EdgeRule::Convex), concave = is(EdgeRule::Concave);
  const bool flat = is(EdgeRule::NearlyFlat);
  all.push_back(measure("convexity", "", e.convexity, 0, true, ""));
  all.back().decided = convex || concave || flat;
  all.push_back(measure("angle of the normals", "deg", e.normal_angle, options.concavity_tolerance,
                        false, "edges.concavity_tolerance"));
  all.back().decided = concave || flat;
  all.push_back(
      measure("common convex neighbours", "", e.support, 1, true, "edges.extended_convexity"));
  all.back().holds = e.support > 0 || !options.extended_convexity;
  all.back().decided = is(EdgeRule::NoSupport);
  return all;
}

/// The shortest decimal beyond `bound`, upwards or down, that is no more than a twentieth further.
std::string just_beyond(double bound, bool up) {
  char text[32];
  for (int digits = 2; digits < 9; ++digits) {
    const double unit =
        std::pow(10.0, std::floor(std::log10(std::max(std::abs(bound), 1e-12))) - (digits - 1));
    const double value =
        up ? (std::floor(bound / unit) + 1) * unit : (std::ceil(bound / unit) - 1) * unit;
    if (std::abs(value - bound) > 0.05 * std::abs(bound) && digits < 8) continue;
    if (std::abs(value - bound) < 2e-6 * std::abs(bound)) continue;  // values are floats
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
  }
  std::snprintf(text, sizeof text, "%.9g", up ? bound * 1.00001 : bound * 0.99999);
  return text;
}

/// Settings of edges.* that put a measure on the other side of its threshold, from eq. (5) of LCCP
/// and the limit of steps turned about.
class EdgeSettings {
 public:
  EdgeSettings(const Segmentation& scene, const Edge& edge) : scene_(scene), edge_(edge) {
    const Patch& a = scene.graph.patches[edge.first];
    const Patch& b = scene.graph.patches[edge.second];
    scale_ = static_cast<double>(std::max(a.scale, b.scale));
    sine_ = static_cast<double>(a.normal.cross(b.normal).norm());
  }

  Setting singular(bool on) const {
    const double growth = 1 + std::exp(-0.25 * (static_cast<double>(edge_.normal_angle) - 25));
    return set("edges.singular_angle", static_cast<double>(edge_.singular_angle) * growth, !on);
  }
  Setting step(bool on) const {
    const double size = static_cast<double>(scene_.graph.patch_size);
    const double bound = (static_cast<double>(edge_.step) / scale_ - sine_ * size) /
                         static_cast<double>(scene_.graph.voxel_size);
    return set("edges.smoothness_tolerance", bound, on);
  }
  Setting concavity(bool on) const {
    return set("edges.concavity_tolerance", static_cast<double>(edge_.normal_angle), on);
  }
  Setting facing(bool on) const {
    const double size = static_cast<double>(scene_.graph.patch_size);
    const double bound = (static_cast<double>(edge_.facing) / scale_ - sine_ * size) /
                         static_cast<double>(scene_.graph.voxel_size);
    return set("edges.smoothness_tolerance", bound, on);
  }
  /// Whether the edge is decided as one of a rim.
  Setting rim(bool by_sides) const {
    return set("edges.rim_angle", static_cast<double>(edge_.normal_angle), !by_sides);
  }
  Setting support(bool on) const {
    return {"edges.extended_convexity", get_option(scene_.options, "edges.extended_convexity"),
            on ? "false" : "true"};
  }

 private:
  Setting set(const char* option, double bound, bool up) const {
    return {option, get_option(scene_.options, option), just_beyond(bound, up)};
  }

  const Segmentation& scene_;
  const Edge& edge_;
  double scale_ = 1, sine_ = 0;
};

/// What may switch an edge off: each alone.
std::vector<std::vector<Setting>> to_switch_off(const EdgeSettings& to, const Edge& edge) {
  std::vector<std::vector<Setting>> all;
  if (edge.rule == EdgeRule::NearlyFlat) all.push_back({to.concavity(false)});
  all.push_back({to.singular(false)});
  all.push_back({to.step(false)});
  all.push_back({to.support(false)});
  return all;
}

/// What it takes to switch an edge on: every test that it fails, together.
std::vector<std::vector<Setting>> to_switch_on(const EdgeSettings& to, const Edge& edge,
                                               const EdgeOptions& options) {
  std::vector<Setting> needed;
  if (edge.singular_angle < edge.singular_limit) needed.push_back(to.singular(true));
  if (edge.step > edge.step_limit) needed.push_back(to.step(true));
  const bool concave =
      edge.convexity < 0 && static_cast<double>(edge.normal_angle) >= options.concavity_tolerance;
  if (concave) needed.push_back(to.concavity(true));
  std::vector<std::vector<Setting>> all;
  if (!needed.empty()) all.push_back(needed);
  if (options.extended_convexity) {
    needed.push_back(to.support(true));
    all.push_back(needed);
  }
  return all;
}

}  // namespace

struct EdgeExplainer::Parts {
  explicit Parts(const Segmentation& s) : scene(s), what_if(s) {}
  const Segmentation& scene;
  WhatIf what_if;
  std::vector<std::uint32_t> truth;  // per patch, or empty

  /// Options of edges.* after which the edge flips, on top of `before` (whose trial has it on no
  /// plane).
  void add_edge_flips(std::size_t index, EdgeRule rule, const std::vector<Setting>& before,
                      std::vector<Flip>& flips) {
    Edge edge = scene.edges[index];
    const bool wanted = !edge.on;
    edge.rule = rule;
    const EdgeSettings to(scene, edge);
    const bool sides = static_cast<double>(edge.normal_angle) > scene.options.edges.rim_angle;
    std::vector<std::vector<Setting>> tried =
        wanted ? to_switch_on(to, edge, scene.options.edges) : to_switch_off(to, edge);
    tried.push_back({to.rim(!sides)});
    if (sides) tried.push_back({to.facing(wanted)});
    for (std::vector<Setting> settings : tried) {
      settings.insert(settings.begin(), before.begin(), before.end());
      const Trial* trial = what_if(settings);
      if (trial == nullptr || joins(trial->rules[index]) != wanted) continue;
      flips.push_back(WhatIf::flip_of(*trial, settings));
    }
  }

  /// Where no option alone flips an edge of the plane rules: one that takes both patches off their
  /// planes, with one that decides the edge then.
  void add_double_flips(std::size_t index, std::vector<Flip>& flips) {
    for (const char* option : {"planes.min_area", "planes.sigma", "planes.normal_gate"}) {
      for (const Setting& setting : ladder(scene.options, option)) {
        const Trial* trial = what_if({setting});
        if (trial == nullptr || by_planes(trial->rules[index])) continue;
        add_edge_flips(index, trial->rules[index], {setting}, flips);
        break;
      }
    }
  }

  std::vector<Flip> seek(std::size_t index) {
    const Edge& edge = scene.edges[index];
    std::vector<Flip> flips;
    if (!by_planes(edge.rule)) add_edge_flips(index, edge.rule, {}, flips);
    const std::vector<Flip> by_plane = what_if.seek_plane_flips(
        [&](const Trial& trial) { return joins(trial.rules[index]) != edge.on; });
    flips.insert(flips.end(), by_plane.begin(), by_plane.end());
    if (flips.empty() && by_planes(edge.rule)) add_double_flips(index, flips);
    for (Flip& flip : flips) flip.rule = what_if(flip.settings)->rules[index];
    return flips;
  }
};

EdgeExplainer::EdgeExplainer(const Segmentation& scene) : parts_(std::make_unique<Parts>(scene)) {}
EdgeExplainer::~EdgeExplainer() = default;

void EdgeExplainer::set_truth(std::vector<std::uint32_t> labels) {
  if (labels.size() != parts_->scene.graph.patches.size())
    throw Error(Error::Kind::Usage, "explain: truth of " + std::to_string(labels.size()) +
                                        " patches, the scene has " +
                                        std::to_string(parts_->scene.graph.patches.size()));
  parts_->truth = std::move(labels);
}

EdgeExplanation EdgeExplainer::operator()(std::size_t index, Flips with_flips) {
  const Segmentation& scene = parts_->scene;
  if (!scene.method.is_ours())
    throw Error(Error::Kind::Usage, "explain: the result is of method `" + scene.method.name +
                                        "`, which says nothing of its edges; segment with ours");
  if (index >= scene.edges.size())
    throw Error(Error::Kind::Usage, "explain: there is no edge " + std::to_string(index) +
                                        "; the graph has " + std::to_string(scene.edges.size()));
  EdgeExplanation x;
  x.index = index;
  x.edge = scene.edges[index];
  x.first = report_patch(scene, x.edge.first);
  x.second = report_patch(scene, x.edge.second);
  x.measures = measures_of(scene, x);
  x.words = explain(scene, x.edge);
  if (!parts_->truth.empty()) {
    x.error = judge_edges({x.edge}, parts_->truth).front();
    x.first.truth = parts_->truth[x.edge.first];
    x.second.truth = parts_->truth[x.edge.second];
  }
  if (with_flips == Flips::Seek) x.flips = parts_->seek(index);
  return x;
}

}  // namespace planescope
