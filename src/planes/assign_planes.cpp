// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/labelling.hpp"
#include "planescope/planes.hpp"

namespace planescope {

std::vector<std::int32_t> assign_planes(const PatchGraph& graph, const std::vector<Plane>& planes,
                                        const PlaneOptions& options, const Progress& progress) {
  if (progress) progress("assignment", 0);
  const LabellingProblem problem = make_labelling_problem(graph, planes, options);
  const Labels start = cheapest_labels(problem);
  Labels labels = options.assignment == AssignmentSolver::Icm ? relax_labels(problem, start)
                                                              : expand_labels(problem, start);
  if (progress) progress("assignment", 1);
  return labels;
}

}  // namespace planescope
