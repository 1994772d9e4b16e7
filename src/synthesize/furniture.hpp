// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "synthesize/scene.hpp"

/// \file Furniture of seeded size and colour, each in its own frame: z up, standing on z = 0,
/// centred on x = y = 0 (but for leaning backs), its front towards -y.
namespace planescope::synthesis {

/// A top on four legs, at a height for eating and writing.
Piece make_table(Random& random);

/// The same, low.
Piece make_coffee_table(Random& random);

/// Seat, four legs, and a back that leans by 4 to 10 degrees: a true slanted plane.
Piece make_chair(Random& random);

/// A cardboard box with a strip of tape. \param size [m] about the length of its edges.
Piece make_box(Random& random, double size);

/// A bookcase: two sides, a back, boards.
Piece make_shelf(Random& random);

/// Frame, mattress, headboard (at +y) and pillows.
Piece make_bed(Random& random);

/// A wardrobe with two doors.
Piece make_cupboard(Random& random);

Piece make_ball(Random& random, double radius);

/// A cylinder on the floor.
Piece make_bin(Random& random);

/// A cylinder on a table.
Piece make_cup(Random& random);

/// A lamp on the floor: foot, pole and shade are cylinders.
Piece make_lamp(Random& random);

}  // namespace planescope::synthesis
