// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/options.hpp"

namespace planescope {

/// Options::automatic() where the scale has been measured already: it takes longer than patches.
/// \param scale measure_scale(cloud). \throws Error{Kind::Computation} as Options::automatic().
Options automatic_options(const PointCloud& cloud, CloudScale scale);

}  // namespace planescope
