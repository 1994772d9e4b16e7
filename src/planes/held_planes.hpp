// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/planes.hpp"

namespace planescope {

/// A hypothesis of an earlier run.
struct HeldPlane {
  Plane plane;
  bool selected = false;
};

/// A plane that was selected pays this much less: one that is worth about as much as not stays
/// selected, else a wall would come and go as the map grows, and objects with it.
inline constexpr double kHoldBonus = 0.2;

/// What an earlier run over most of the same patches found: the search for planes goes on from
/// there. A map that grows knows its walls; only patches that are new may propose others.
struct HeldPlanes {
  std::vector<HeldPlane> supporting;  ///< hypotheses that had more than lambda inliers
  std::vector<HeldPlane> faces;       ///< likewise among the patches on no plane
  std::vector<std::uint8_t> fresh;    ///< per patch: 1 if the earlier run did not have it
};

}  // namespace planescope
