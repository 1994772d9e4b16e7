// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "planescope/options.hpp"
#include "planescope/patches.hpp"
#include "planescope/planes.hpp"

/// \file The energy of eq. (10) in integers, and what lowers it.
namespace planescope {

/// Costs are multiples of 1 / kCostUnit: sums are exact, the same in every order.
inline constexpr double kCostUnit = 4096;

/// A plane that a patch may have, or a patch that may have a plane, and what that costs.
struct Choice {
  std::uint32_t index = 0;
  std::int32_t cost = 0;
};

/// E(L) = sum U + w * sum over edges [l_i != l_j]: labels 0 .. labels() - 1 where they are allowed,
/// and kNone everywhere.
struct LabellingProblem {
  std::vector<std::uint32_t> choice_offsets;     ///< per patch, into `choices`
  std::vector<Choice> choices;                   ///< planes of each patch, ascending
  std::vector<std::uint32_t> member_offsets;     ///< per plane, into `members`
  std::vector<Choice> members;                   ///< patches of each plane, ascending
  std::int32_t none_cost = 0;                    ///< U of "no plane"
  std::int32_t potts = 0;                        ///< w
  std::vector<std::uint32_t> neighbour_offsets;  ///< per patch, into `neighbours`
  std::vector<std::uint32_t> neighbours;         ///< of each patch

  std::size_t size() const { return choice_offsets.size() - 1; }
  std::size_t labels() const { return member_offsets.size() - 1; }
  std::span<const Choice> choices_of(std::size_t patch) const {
    return {choices.data() + choice_offsets[patch], choices.data() + choice_offsets[patch + 1]};
  }
  std::span<const Choice> members_of(std::size_t plane) const {
    return {members.data() + member_offsets[plane], members.data() + member_offsets[plane + 1]};
  }
  std::span<const std::uint32_t> neighbours_of(std::size_t patch) const {
    return {neighbours.data() + neighbour_offsets[patch],
            neighbours.data() + neighbour_offsets[patch + 1]};
  }
};

using Labels = std::vector<std::int32_t>;

/// Sets eq. (10) up: U = r / sigma of planes that pass the normal gate.
///
/// Differs from the paper: a plane at r >= 2 sigma is not allowed. It costs more than "no plane"
/// there, and only neighbours could talk a patch into it, such as those around a small object.
LabellingProblem make_labelling_problem(const PatchGraph& graph, const std::vector<Plane>& planes,
                                        const PlaneOptions& options);

/// E(L), in units of 1 / kCostUnit. Every label has to be allowed.
std::int64_t labelling_energy(const LabellingProblem& problem, const Labels& labels);

/// The labels of least U, ties to the lower plane: where both solvers start.
Labels cheapest_labels(const LabellingProblem& problem);

/// Alpha-expansion (Boykov, Veksler, Zabih, PAMI 2001): for each label, "no plane" too, the best
/// move that lets any set of patches take it, until none lowers E. At most twice the optimum for
/// the Potts model; the optimum itself for one plane.
Labels expand_labels(const LabellingProblem& problem, Labels labels);

/// Iterated conditional modes (Besag 1986): each patch in turn takes its best label, until nothing
/// changes.
Labels relax_labels(const LabellingProblem& problem, Labels labels);

}  // namespace planescope
