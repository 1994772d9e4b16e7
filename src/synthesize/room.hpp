// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "synthesize/scene.hpp"

namespace planescope::synthesis {

/// A room and what stands in it.
struct Room {
  Scene scene;
  Isometry3d frame;  ///< the room's frame (centre of the floor, walls along x and y) to the world
  Vector3d half;     ///< [m] half its width, depth and height
  std::uint32_t structures = 0;  ///< labels 1 .. structures are floor, walls and ceiling
};

/// A furnished room: 4-7 m x 3.5-6 m x 2.4-2.8 m, turned about z; a bed, a cupboard, 1-2 shelves,
/// 2-3 tables, 3-6 chairs, 4-8 boxes, 2-4 balls and 2-4 cylinders (bin, cup, lamp).
Room make_room(std::uint64_t seed, bool ceiling);

}  // namespace planescope::synthesis
