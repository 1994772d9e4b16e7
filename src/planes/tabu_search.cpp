// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <random>

#include "planes/random.hpp"
#include "planes/solvers.hpp"

namespace planescope {
namespace {

/// The best flip that is allowed at this step, the first of equal ones, or size() if none is.
std::size_t best_move(const FlipState& state, const std::vector<std::uint64_t>& tabu_until,
                      std::uint64_t step, double best_energy) {
  std::size_t best = state.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < state.size(); ++m) {
    const double change = state.change(m);
    if (!(change < least)) continue;  // mostly: what is tabu need not be asked
    const bool aspires = state.energy() + change < best_energy - FlipState::kRounding;
    if (tabu_until[m] > step && !aspires) continue;
    best = m;
    least = change;
  }
  return best;
}

}  // namespace

SolverRun tabu_search(const SelectionEnergy& energy, std::uint32_t steps) {
  FlipState state(energy);
  for (std::size_t m; (m = state.best_descent()) < state.size();) state.flip(m);
  SolverRun run{.x = state.x(), .energies = {state.energy()}};
  double best = state.energy();

  // A tenure that varies breaks cycles; it stays below n, so that something can always move.
  const std::size_t n = state.size();
  const std::uint64_t longest = n > 1 ? std::min<std::uint64_t>(n - 1, 10 + n / 20) : 0;
  const std::uint64_t shortest = longest / 3;
  std::mt19937_64 random(n);
  std::vector<std::uint64_t> tabu_until(n, 0);
  for (std::uint64_t step = 0; step < steps; ++step) {
    const std::size_t m = best_move(state, tabu_until, step, best);
    if (m == n) continue;
    state.flip(m);
    tabu_until[m] = step + 1 + shortest + uniform_index(random, longest - shortest + 1);
    if (state.energy() < best - FlipState::kRounding) {
      best = state.energy();
      run.x = state.x();
      run.energies.push_back(best);
    }
  }
  return run;
}

}  // namespace planescope
