// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planes/held_planes.hpp"
#include "planes/patch_index.hpp"
#include "planes/plane_search.hpp"
#include "planescope/options.hpp"

/// \file Section IV-A of the paper: plane hypotheses.
namespace planescope {

/// What enters selection.
struct Hypotheses {
  std::vector<Hypothesis> kept;  ///< by support, descending; each with more than lambda inliers
  std::uint32_t proposed = 0;    ///< flat patches and triples that proposed
};

/// lambda of eq. (4) in patches: min_area / median patch area, and at least 3 (fewer patches fix no
/// plane). The median is weighted by area: it is the patch that a random piece of surface lies in,
/// whatever number of specks a sparse scan leaves. Where patches have no area lambda is 3.
double support_threshold(const std::vector<Patch>& patches, double min_area);

/// Proposes planes from flat patches and from random triples, refits each to its inliers, merges
/// near-duplicates, drops those that D refuses, and keeps at most options.max_hypotheses, those
/// with most inliers.
///
/// Differs from the paper in how the work is bounded:
/// - with many patches a spatially even sample of them proposes, large enough that a plane of
///   lambda inliers keeps about two dozen in it; the survivors are refitted to all patches;
/// - a flat patch that is a close inlier of a plane refitted earlier proposes nothing, because its
///   refit would end there, and neither does a triple whose plane is close to one;
/// - a plane with at most lambda inliers is dropped: its D is not negative and V never is, so that
///   no optimum needs it.
Hypotheses propose_hypotheses(const PatchIndex& index, const PlaneOptions& options, double lambda);

/// The same where planes are known already: these are refitted to the patches as they are now, and
/// only fresh patches that lie close to none of them propose others. \param held planes known.
/// \param fresh per patch of the index: 1 if it may propose.
Hypotheses renew_hypotheses(const PatchIndex& index, const PlaneOptions& options, double lambda,
                            const std::vector<HeldPlane>& held,
                            const std::vector<std::uint8_t>& fresh);

/// Of several hypotheses with nearly the same plane (5 degrees) and inliers (80 % of the larger
/// set) only the one with most inliers remains, held if one of them is. The result is sorted by
/// support, descending; ties keep the given order.
std::vector<Hypothesis> merge_duplicates(std::vector<Hypothesis> hypotheses);

}  // namespace planescope
