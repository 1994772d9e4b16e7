// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planes/support.hpp"

namespace planescope {

/// Takes planes apart into their connected pieces, and fits each to its own patches. A plane among
/// furniture gathers all that lies within sigma of it, and two seats at a distance, one a little
/// higher than the other, tilt it, although each alone is level. Pieces of fewer than `fewest`
/// patches go to the piece of the same plane that they lie nearest to, if that is within 2 sigma
/// (as far as the assignment lets patches lie), else to none. A plane without a larger piece stays
/// whole. \param assignment per patch: index into `planes`, or kNone.
/// \returns the pieces as planes, by area, descending; each patch's piece.
Support refit_pieces(const PatchGraph& graph, const std::vector<Plane>& planes,
                     const std::vector<std::int32_t>& assignment, const PlaneOptions& options,
                     double fewest);

}  // namespace planescope
