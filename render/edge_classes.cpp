// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_classes.hpp"

#include <algorithm>
#include <array>

#include <vtkCellData.h>
#include <vtkDataArray.h>

#include "palette.hpp"
#include "planescope/truth_errors.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

constexpr double kThin = 1.0, kThick = 2.4;

std::vector<EdgeClass> state_kinds() {
  return {{"off", "OFF", kEdgeOff, kThick, 0}, {"on", "ON", kEdgeOn, kThin, 0}};
}

/// ON thin in cold colours, OFF thick in warm ones. \returns indexed by EdgeRule.
std::vector<EdgeClass> rule_kinds() {
  static constexpr std::array<Pixel, kEdgeRuleCount> kColors = {{{150, 178, 210},
                                                                 {122, 62, 16},
                                                                 {244, 140, 6},
                                                                 {20, 60, 160},
                                                                 {16, 150, 130},
                                                                 {214, 32, 40},
                                                                 {226, 88, 190},
                                                                 {116, 44, 170},
                                                                 {40, 40, 40}}};
  std::vector<EdgeClass> kinds;
  for (std::size_t i = 0; i < kEdgeRuleCount; ++i) {
    const auto rule = static_cast<EdgeRule>(i);
    const bool on =
        rule == EdgeRule::SamePlane || rule == EdgeRule::Convex || rule == EdgeRule::NearlyFlat;
    const std::string key(name(rule));
    kinds.push_back({key, key + (on ? " (ON)" : " (OFF)"), kColors[i], on ? kThin : kThick, 0});
  }
  return kinds;
}

constexpr std::array<double, 3> kMargins = {0.05, 0.15, 0.4};

/// Near the threshold bright and thick, far from it pale and thin.
std::vector<EdgeClass> margin_kinds() {
  return {{"below_0.05", "margin below 0.05", {190, 18, 60}, 3.2, 0},
          {"below_0.15", "margin 0.05 to 0.15", {240, 120, 20}, 2.4, 0},
          {"below_0.4", "margin 0.15 to 0.4", {120, 150, 90}, 1.4, 0},
          {"from_0.4", "margin 0.4 and more", {150, 172, 205}, 0.8, 0}};
}

/// Indexed by EdgeError.
std::vector<EdgeClass> truth_kinds() {
  return {{"right", "right", {150, 172, 205}, 0.8, 0},
          {"merged", "ON across two objects", {190, 18, 60}, 3.4, 0},
          {"cut", "OFF inside one object", {116, 44, 170}, 2.6, 0},
          {"unjudged", "not judged", {200, 200, 200}, 0.8, 0}};
}

/// The numbers of one edge that kinds go by.
struct Columns {
  explicit Columns(const SceneData& scene)
      : on(*scene.graph->GetCellData()->GetArray("on")),
        rule(*scene.graph->GetCellData()->GetArray("rule")),
        margin(*scene.graph->GetCellData()->GetArray("margin")),
        lines(*scene.graph->GetLines()) {}

  Edge edge(vtkIdType i) const {
    Edge edge;
    const auto ends = corners(lines, i);
    edge.first = static_cast<std::uint32_t>(ends[0]);
    edge.second = static_cast<std::uint32_t>(ends[1]);
    edge.on = on.GetTuple1(i) != 0;
    edge.rule = static_cast<EdgeRule>(static_cast<std::uint8_t>(rule.GetTuple1(i)));
    edge.margin = static_cast<float>(margin.GetTuple1(i));
    return edge;
  }

  vtkDataArray &on, &rule, &margin;
  vtkCellArray& lines;
};

bool passes(const Edge& edge, const EdgeFilter& only) {
  return (!only.on || edge.on == *only.on) && (!only.rule || edge.rule == *only.rule) &&
         static_cast<double>(edge.margin) < only.margin_below;
}

std::size_t margin_kind(const Edge& edge) {
  const auto m = static_cast<double>(edge.margin);
  return static_cast<std::size_t>(std::ranges::upper_bound(kMargins, m) - kMargins.begin());
}

}  // namespace

EdgeClasses classify(const SceneData& scene, const GraphOptions& options,
                     const std::vector<std::uint32_t>& patch_truth) {
  EdgeClasses classes;
  classes.kinds = options.color == EdgeColor::State    ? state_kinds()
                  : options.color == EdgeColor::Rule   ? rule_kinds()
                  : options.color == EdgeColor::Margin ? margin_kinds()
                                                       : truth_kinds();
  const Columns columns(scene);
  for (vtkIdType i = 0; i < scene.graph->GetNumberOfCells(); ++i) {
    const Edge edge = columns.edge(i);
    if (!passes(edge, options.only)) {
      classes.of.push_back(EdgeClasses::kHidden);
      continue;
    }
    std::size_t kind = edge.on ? 1 : 0;
    if (options.color == EdgeColor::Rule) kind = static_cast<std::size_t>(edge.rule);
    if (options.color == EdgeColor::Margin) kind = margin_kind(edge);
    if (options.color == EdgeColor::Truth)
      kind = static_cast<std::size_t>(judge_edges({edge}, patch_truth).front());
    ++classes.kinds[kind].count;
    classes.of.push_back(static_cast<std::uint8_t>(kind));
  }
  return classes;
}

}  // namespace planescope::draw
