// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <string>

#include "planes/solvers.hpp"
#include "planescope/error.hpp"

namespace planescope {

SolverRun exhaustive_search(const SelectionEnergy& energy) {
  constexpr std::size_t kMost = 24;
  const std::size_t n = energy.size();
  if (n > kMost) {
    throw Error(Error::Kind::Usage, "planes.solver exhaustive: " + std::to_string(n) +
                                        " hypotheses, expected at most " + std::to_string(kMost) +
                                        "; use lsa_tr+tabu, or lower planes.max_hypotheses");
  }
  FlipState state(energy);
  SolverRun run{.x = state.x(), .energies = {0}};
  const std::uint64_t subsets = std::uint64_t{1} << n;
  for (std::uint64_t code = 1; code < subsets; ++code) {
    state.flip(static_cast<std::size_t>(std::countr_zero(code)));
    if (state.energy() < run.energies.back() - FlipState::kRounding) {
      run.x = state.x();
      run.energies.push_back(state.energy());
    }
  }
  return run;
}

std::vector<bool> minimise_selection(const SelectionEnergy& energy, PlaneSolver solver,
                                     std::uint32_t tabu_steps) {
  if (solver == PlaneSolver::Exhaustive) return exhaustive_search(energy).x;
  const SolverRun first = lsa_tr(energy);
  if (solver == PlaneSolver::LsaTr) return first.x;
  const SolverRun second = tabu_search(energy, tabu_steps);
  return energy(second.x) < energy(first.x) - FlipState::kRounding ? second.x : first.x;
}

}  // namespace planescope
