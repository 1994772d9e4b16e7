// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "planescope/explain.hpp"
#include "planescope/pipeline.hpp"

/// \file What the method would answer with other options, from the patches of a scene on: the
/// stages behind them are run again, patches are kept.
namespace planescope {

/// The stages' results with other options.
struct Outcome {
  PatchGraph graph;  ///< with the normals of the faces then; empty where the planes are the scene's
  std::vector<SupportingPlane> planes;
  std::vector<PatchPlane> patch_plane;
  std::vector<std::int32_t> patch_face;
  std::vector<Edge> edges;
  SegmentSet segments;
};

/// segment() from the patches on. Planes are taken over where no option of `planes.*` differs.
/// Options of `patches.*` must be those of the scene.
Outcome rerun(const Segmentation& scene, const Options& options);

/// What is kept of an outcome, to be asked about many edges and places.
struct Trial {
  std::vector<EdgeRule> rules;  ///< per edge
  std::vector<PatchPlane> patch_plane;
  std::vector<std::int32_t> patch_face;
  std::vector<SupportingPlane> planes;
  std::size_t switched_on = 0, switched_off = 0, segments = 0;
};

/// True for rules that leave an edge ON.
bool joins(EdgeRule rule);

/// Options with some of them set.
Options with(Options options, const std::vector<Setting>& settings);

/// Settings of one option in the order in which they are tried: nearest to its value first.
std::vector<Setting> ladder(const Options& options, const std::string& option);

/// Options of `planes.*` that have a ladder.
const std::vector<std::string>& plane_ladders();

/// Trials of one scene, each made once.
class WhatIf {
 public:
  /// The scene must outlive it.
  explicit WhatIf(const Segmentation& scene) : scene_(scene) {}

  /// Nothing if the settings are refused: out of range, or contradicting other options.
  const Trial* operator()(const std::vector<Setting>& settings);

  /// The first setting of each option's ladder after which `changed` holds, as a flip; smallest
  /// changes first.
  std::vector<Flip> seek_plane_flips(const std::function<bool(const Trial&)>& changed,
                                     const std::vector<std::string>& options = plane_ladders());

  /// A trial's figures; `rule` is left as it is.
  static Flip flip_of(const Trial& trial, const std::vector<Setting>& settings);

 private:
  const Segmentation& scene_;
  std::map<std::string, std::optional<Trial>> trials_;  // by settings, as text
};

}  // namespace planescope
