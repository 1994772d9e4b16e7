// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planes/held_planes.hpp"
#include "planescope/planes.hpp"

namespace planescope {

/// select_planes() that goes on from `held`; null: from nothing.
PlaneSelection renew_planes(const PatchGraph& graph, const PlaneOptions& options,
                            const HeldPlanes* held, const Progress& progress = {});

}  // namespace planescope
