// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/planes.hpp"

namespace planescope {

/// What an earlier run over most of the same patches found: the search for planes goes on from
/// there. A map that grows knows its walls; only patches that are new may propose others.
struct HeldPlanes {
  std::vector<Plane> supporting;    ///< hypotheses that had more than lambda inliers, selected or not
  std::vector<Plane> faces;         ///< likewise among the patches on no plane
  std::vector<std::uint8_t> fresh;  ///< per patch: 1 if the earlier run did not have it
};

}  // namespace planescope
