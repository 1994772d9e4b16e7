// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "synthesize/camera.hpp"

namespace planescope::synthesis {

/// Cameras of a hand-held sensor that is carried three times around the room's middle, in free
/// space: the first time it looks across the room, nodding from above the horizon to 40 degrees
/// below; then outwards, first along the walls' upper halves, then at what stands before them.
std::vector<Camera> walk_through(const Room& room, std::uint64_t seed, std::uint32_t frames);

}  // namespace planescope::synthesis
