// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/planes.hpp"

/// \file Minimisers of the selection energy. All of its pairwise terms are supermodular (V >= 0),
/// which no graph cut minimises.
namespace planescope {

/// A minimiser's answer and how it came to it.
struct SolverRun {
  std::vector<bool> x;
  std::vector<double> energies;  ///< E at the start and after each accepted step
};

/// LSA-TR (Gorelick et al., "Submodularization for Binary Pairwise Energies", CVPR 2014): the
/// supermodular terms are replaced by their linear approximation at the current x, here all of
/// them, so that minimising it plus mu * Hamming distance to x means to flip every variable whose
/// linear gain exceeds mu; mu follows the ratio of actual to predicted reduction. Starts, as the
/// paper, at the minimum of the unary terms. Ends where no single flip pays.
SolverRun lsa_tr(const SelectionEnergy& energy);

/// 1-flip tabu search (Glover) for `steps` moves from a greedy start: the best flip that is not
/// tabu, or that leads below the best energy seen (aspiration), is made even if it costs; the
/// flipped variable is then tabu for some steps. Ties go to the lower index. Returns the best x
/// seen.
SolverRun tabu_search(const SelectionEnergy& energy, std::uint32_t steps);

/// All subsets in the order of the Gray code; of equal ones the first. \throws Error{Kind::Usage}
/// more than 24 hypotheses.
SolverRun exhaustive_search(const SelectionEnergy& energy);

/// A set of hypotheses with what each flip would change, kept up to date at O(n) a flip.
class FlipState {
 public:
  /// Starts empty: E = 0. The energy must outlive it.
  explicit FlipState(const SelectionEnergy& energy)
      : energy_(&energy),
        x_(energy.size(), false),
        field_(energy.unary),
        sign_(energy.size(), 1.0) {}

  std::size_t size() const { return x_.size(); }
  const std::vector<bool>& x() const { return x_; }
  double energy() const { return value_; }

  /// E after flipping m minus E now.
  double change(std::size_t m) const { return sign_[m] * field_[m]; }

  void flip(std::size_t m) {
    value_ += change(m);
    const double sign = sign_[m];
    const double* row = &energy_->pairwise[m * size()];
    for (std::size_t k = 0; k < size(); ++k) field_[k] += sign * row[k];
    x_[m] = !x_[m];
    sign_[m] = -sign;
  }

  /// The flip that lowers E most (lowest index of equal ones); size() if none does by more than
  /// rounding.
  std::size_t best_descent() const {
    std::size_t best = size();
    double least = -kRounding;
    for (std::size_t m = 0; m < size(); ++m) {
      if (change(m) < least) best = m, least = change(m);
    }
    return best;
  }

  static constexpr double kRounding = 1e-12;  ///< energies that differ less are equal

 private:
  const SelectionEnergy* energy_;
  std::vector<bool> x_;
  std::vector<double> field_;  ///< D_m + sum of V_mn x_n
  std::vector<double> sign_;   ///< of what a flip does: 1 where x is false, else -1
  double value_ = 0;
};

}  // namespace planescope
