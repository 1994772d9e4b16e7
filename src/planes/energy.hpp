// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planes/plane_search.hpp"
#include "planescope/options.hpp"
#include "planescope/patches.hpp"
#include "planescope/planes.hpp"

/// \file Eqs. (3) to (6) over a set of hypotheses.
namespace planescope {

/// V of eq. (6) in its two weighted terms, n x n, symmetric, zero diagonal, row-major.
struct PairTerms {
  std::vector<double> angle;    ///< weight_angle * (1 - exp(-A^ / alpha)); 0 where out of scope
  std::vector<double> overlap;  ///< weight_overlap * |I_m n I_n| / min(|I_m|, |I_n|); 0/0 is 0
};

/// The pair terms of all hypotheses; `graph` is what `index` was made of.
PairTerms pair_terms(const std::vector<Hypothesis>& hypotheses, const PatchIndex& index,
                     const PatchGraph& graph, const PlaneOptions& options);

/// E(X) of hypotheses with these pair terms.
SelectionEnergy selection_energy(const std::vector<Hypothesis>& hypotheses, const PairTerms& pairs,
                                 double lambda);

/// For each hypothesis m: E with it minus E without it, the others held as in x (as long as n).
std::vector<double> flip_costs(const SelectionEnergy& energy, const std::vector<bool>& x);

}  // namespace planescope
