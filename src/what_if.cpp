// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "what_if.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "planescope/error.hpp"
#include "segment_graph.hpp"

namespace planescope {
namespace {

bool same_plane_options(const Options& a, const Options& b) {
  for (const OptionInfo& info : option_table()) {
    if (info.name.starts_with("planes.") && get_option(a, info.name) != get_option(b, info.name))
      return false;
  }
  return true;
}

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// How far a value lies from the present one: in steps of a doubling where it is a length or an
/// area, else as a share of the range that the ladder spans.
struct Rung {
  double value = 0, distance = 0;
};

std::vector<Rung> rungs(const std::string& option, double now) {
  std::vector<Rung> all;
  const auto scaled = [&](std::initializer_list<double> factors) {
    for (const double f : factors) all.push_back({now * f, std::abs(std::log2(f))});
  };
  const auto fixed = [&](std::initializer_list<double> values, double range) {
    for (const double v : values) all.push_back({v, std::abs(v - now) / range * 4});
  };
  if (option == "planes.sigma")
    scaled({0.95, 0.9, 0.8, 0.7, 0.6, 0.5, 0.35, 0.25, 1.05, 1.1, 1.25, 1.5, 2, 3, 4});
  else if (option == "planes.min_area" || option == "planes.face_area")
    scaled({0.8, 0.6, 0.4, 0.25, 0.15, 0.1, 0.05, 1.25, 1.6, 2.5, 4, 6, 10});
  else if (option == "planes.smoothness")
    scaled({0, 0.25, 0.5, 2, 4});
  else if (option == "planes.normal_gate")
    fixed({0.3, 0.5, 0.6, 0.7, 0.75, 0.85, 0.9, 0.94, 0.97, 0.985}, 0.5);
  else if (option == "planes.alpha")
    fixed({2.5, 5, 10, 20, 30, 45}, 45);
  else if (option == "planes.max_curvature")
    fixed({0.05, 0.1, 0.2, 0.33}, 0.33);
  else
    fixed({0, 0.5, 1, 2}, 2);  // the weights
  return all;
}

}  // namespace

bool joins(EdgeRule rule) {
  return rule == EdgeRule::SamePlane || rule == EdgeRule::Convex || rule == EdgeRule::NearlyFlat;
}

Outcome rerun(const Segmentation& scene, const Options& options) {
  if (!same_plane_options(scene.options, options)) {
    Segmentation then;  // without the points, which patches are already made of
    then.graph.patches = scene.graph.patches;
    then.graph.adjacency = scene.graph.adjacency;
    then.graph.voxel_size = scene.graph.voxel_size;
    then.graph.patch_size = scene.graph.patch_size;
    for (Patch& patch : then.graph.patches) patch.normal = patch.own_normal;
    segment_graph(then, options);
    return {std::move(then.graph),      std::move(then.planes), std::move(then.patch_plane),
            std::move(then.patch_face), std::move(then.edges),  std::move(then.segments)};
  }
  Outcome same{{}, scene.planes, scene.patch_plane, scene.patch_face, {}, {}};
  same.edges = classify_edges(scene.graph, same.patch_plane, options.edges);
  same.segments = connect_segments(scene.graph, same.edges, same.patch_plane, options.segments);
  return same;
}

Options with(Options options, const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) set_option(options, setting.option, setting.to);
  return options;
}

const std::vector<std::string>& plane_ladders() {
  static const std::vector<std::string> kNames = {
      "planes.sigma",          "planes.min_area",     "planes.normal_gate", "planes.smoothness",
      "planes.weight_overlap", "planes.weight_angle", "planes.alpha",       "planes.max_curvature"};
  return kNames;
}

std::vector<Setting> ladder(const Options& options, const std::string& option) {
  const std::string from = get_option(options, option);
  std::vector<Rung> all = rungs(option, std::stod(from));
  std::ranges::stable_sort(all, {}, &Rung::distance);
  std::vector<Setting> settings;
  for (const Rung& rung : all) {
    if (short_text(rung.value) != from) settings.push_back({option, from, short_text(rung.value)});
  }
  return settings;
}

const Trial* WhatIf::operator()(const std::vector<Setting>& settings) {
  std::string key;
  for (const Setting& setting : settings) key += setting.option + "=" + setting.to + " ";
  const auto [place, is_new] = trials_.try_emplace(key);
  std::optional<Trial>& trial = place->second;
  if (!is_new) return trial ? &*trial : nullptr;
  try {
    const Options options = with(scene_.options, settings);
    options.validate();
    Outcome outcome = rerun(scene_, options);
    trial.emplace();
    for (std::size_t e = 0; e < outcome.edges.size(); ++e) {
      trial->rules.push_back(outcome.edges[e].rule);
      const bool now = outcome.edges[e].on, before = scene_.edges[e].on;
      if (now && !before) ++trial->switched_on;
      if (!now && before) ++trial->switched_off;
    }
    trial->segments = outcome.segments.segments.size();
    trial->planes = std::move(outcome.planes);
    trial->patch_plane = std::move(outcome.patch_plane);
    trial->patch_face = std::move(outcome.patch_face);
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::Usage) throw;
    trial.reset();
  }
  return trial ? &*trial : nullptr;
}

Flip WhatIf::flip_of(const Trial& trial, const std::vector<Setting>& settings) {
  Flip flip;
  flip.settings = settings;
  flip.switched_on = trial.switched_on;
  flip.switched_off = trial.switched_off;
  flip.planes = trial.planes.size();
  flip.segments = trial.segments;
  return flip;
}

std::vector<Flip> WhatIf::seek_plane_flips(const std::function<bool(const Trial&)>& changed,
                                           const std::vector<std::string>& options) {
  std::vector<std::pair<std::size_t, Flip>> found;  // rank in its ladder
  for (const std::string& option : options) {
    const std::vector<Setting> settings = ladder(scene_.options, option);
    for (std::size_t rank = 0; rank < settings.size(); ++rank) {
      const Trial* trial = (*this)({settings[rank]});
      if (trial == nullptr || !changed(*trial)) continue;
      found.emplace_back(rank, flip_of(*trial, {settings[rank]}));
      break;
    }
  }
  // The change that leaves most of the scene as it is comes first.
  std::ranges::stable_sort(
      found, {}, [](const auto& f) { return f.second.switched_on + f.second.switched_off; });
  std::vector<Flip> flips;
  flips.reserve(found.size());
  for (auto& [rank, flip] : found) flips.push_back(std::move(flip));
  return flips;
}

}  // namespace planescope
