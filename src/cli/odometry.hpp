// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/sequence.hpp"

namespace planescope::cli {

struct Console;

/// Gives a sequence without poses those that odometry estimates, by the program planescope-odometry
/// beside this one (or the one that the environment's PLANESCOPE_ODOMETRY names), in a world whose
/// z is up as the cameras were held; warns that they drift, and says how many frames were lost.
/// \throws Error{Kind::Input} there is no such program, so poses are needed; Error as
/// estimate_poses() does.
void give_poses(Sequence& sequence, const Console& console);

}  // namespace planescope::cli
