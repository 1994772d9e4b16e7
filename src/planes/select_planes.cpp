// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/energy.hpp"
#include "planes/hypotheses.hpp"
#include "planes/renew_planes.hpp"
#include "planescope/planes.hpp"

namespace planescope {
namespace {

PlaneHypothesis describe(const Hypothesis& hypothesis, const PatchIndex& index, double lambda) {
  PlaneHypothesis result;
  result.plane = hypothesis.plane;
  result.inlier_count = hypothesis.support;
  result.data_cost = data_cost(hypothesis.support, lambda);
  double area = 0;
  for_each(hypothesis.inliers, [&](std::size_t i) { area += static_cast<double>(index.area(i)); });
  result.inlier_area = static_cast<float>(area);
  return result;
}

/// Names the selected hypothesis whose V cost a rejected one most; none if no V cost it anything.
void explain_rejection(PlaneHypothesis& rejected, std::size_t m, const PairTerms& pairs,
                       const std::vector<std::uint32_t>& selected, std::size_t n) {
  double most = 0;
  for (const std::uint32_t k : selected) {
    const double angle = pairs.angle[m * n + k], overlap = pairs.overlap[m * n + k];
    if (angle + overlap <= most) continue;
    most = angle + overlap;
    rejected.blocked_by = static_cast<std::int32_t>(k);
    rejected.blocked_angle_cost = angle;
    rejected.blocked_overlap_cost = overlap;
  }
}

void select(PlaneSelection& selection, const SelectionEnergy& energy, const PairTerms& pairs,
            const PlaneOptions& options) {
  const std::vector<bool> x = minimise_selection(energy, options.solver, options.tabu_steps);
  const std::vector<double> costs = flip_costs(energy, x);
  selection.energy = energy(x);
  for (std::uint32_t m = 0; m < x.size(); ++m) {
    selection.hypotheses[m].selected = x[m];
    selection.hypotheses[m].flip_cost = costs[m];
    if (x[m]) selection.selected.push_back(m);
  }
  for (std::size_t m = 0; m < x.size(); ++m) {
    if (!x[m]) {
      explain_rejection(selection.hypotheses[m], m, pairs, selection.selected, x.size());
    }
  }
}

}  // namespace

PlaneSelection select_planes(const PatchGraph& graph, const PlaneOptions& options,
                             const Progress& progress) {
  return renew_planes(graph, options, nullptr, progress);
}

PlaneSelection renew_planes(const PatchGraph& graph, const PlaneOptions& options,
                            const HeldPlanes* held, const Progress& progress) {
  const auto report = [&](std::string_view stage, double fraction) {
    if (progress) progress(stage, fraction);
  };
  report("hypotheses", 0);
  PlaneSelection selection;
  selection.lambda = support_threshold(graph.patches, options.min_area);
  const PatchIndex index(graph.patches);
  const Hypotheses found =
      held == nullptr || held->supporting.empty()
          ? propose_hypotheses(index, options, selection.lambda)
          : renew_hypotheses(index, options, selection.lambda, held->supporting, held->fresh);
  selection.proposed = found.proposed;
  report("hypotheses", 1);

  report("selection", 0);
  for (const Hypothesis& h : found.kept) {
    selection.hypotheses.push_back(describe(h, index, selection.lambda));
  }
  const PairTerms pairs = pair_terms(found.kept, index, graph, options);
  select(selection, selection_energy(found.kept, pairs, selection.lambda), pairs, options);
  report("selection", 1);
  return selection;
}

}  // namespace planescope
