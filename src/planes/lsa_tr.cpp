// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "planes/solvers.hpp"

namespace planescope {
namespace {

/// Variables whose flip the linear approximation says pays, best first, ties by index.
std::vector<std::size_t> paying_flips(const FlipState& state) {
  std::vector<std::size_t> flips;
  for (std::size_t m = 0; m < state.size(); ++m) {
    if (state.change(m) < -FlipState::kRounding) flips.push_back(m);
  }
  std::stable_sort(flips.begin(), flips.end(),
                   [&](std::size_t a, std::size_t b) { return state.change(a) < state.change(b); });
  return flips;
}

/// What the trust-region sub-problem flips: all whose linear gain exceeds mu, and at least the
/// best.
std::size_t threshold(const FlipState& state, const std::vector<std::size_t>& flips, double mu) {
  const auto end = std::find_if(flips.begin(), flips.end(),
                                [&](std::size_t m) { return -state.change(m) <= mu; });
  return std::max<std::size_t>(1, static_cast<std::size_t>(end - flips.begin()));
}

}  // namespace

SolverRun lsa_tr(const SelectionEnergy& energy) {
  constexpr double kStep = 2, kTrusted = 0.25;  // factor of mu; ratio above which mu shrinks
  FlipState state(energy);
  for (std::size_t m = 0; m < energy.size(); ++m) {
    if (energy.unary[m] < 0) state.flip(m);
  }
  SolverRun run{.x = {}, .energies = {state.energy()}};
  double mu = 0.1;
  for (auto flips = paying_flips(state); !flips.empty();) {
    const std::size_t taken = threshold(state, flips, mu);
    double predicted = 0;
    FlipState next = state;
    for (std::size_t i = 0; i < taken; ++i) {
      predicted -= state.change(flips[i]);
      next.flip(flips[i]);
    }
    const double reduction = state.energy() - next.energy();
    const double least_gain = -state.change(flips[taken - 1]);
    if (reduction > 0 || taken == 1) {  // the approximation is exact for one flip: always accepted
      state = next;
      run.energies.push_back(state.energy());
      flips = paying_flips(state);
    } else {
      mu = std::max(mu, least_gain);  // excludes at least the last of the flips, so that it ends
    }
    mu = reduction > kTrusted * predicted ? mu / kStep : mu * kStep;
  }
  run.x = state.x();
  return run;
}

}  // namespace planescope
