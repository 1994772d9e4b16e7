// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "synthesize/scene.hpp"

/// \file Where furniture goes: seeded rejection sampling of poses that touch nothing.
namespace planescope::synthesis {

/// A piece and where it stands, in the room's frame (centre of the floor, walls along x and y).
struct PlacedPiece {
  Piece piece;
  Isometry3d pose;
};

/// A room that fills up. Every place_* tries seeded poses until one is free of collisions with what
/// stands already (boxes around the parts, at least 1.5 cm apart) and inside the walls.
class Placement {
 public:
  /// \param half half the room's width, depth and height.
  Placement(const Vector3d& half, Random& random) : half_(half), random_(random) {}

  /// Its back (+y) against a wall, touching it or up to 3 cm away.
  bool place_at_wall(const Piece& piece);

  /// Anywhere on the floor. \param square keep to multiples of 90 degrees, but for a few.
  bool place_on_floor(const Piece& piece, bool square);

  /// A chair before one of the long sides of a table, facing it.
  bool place_at_table(const Piece& chair);

  /// On one of the tables.
  bool place_on_table(const Piece& piece);

  const std::vector<PlacedPiece>& placed() const { return placed_; }

 private:
  bool fits(const Piece& piece, const Isometry3d& pose, std::optional<std::size_t> support) const;
  bool try_poses(const Piece& piece, int attempts, auto&& propose);

  Vector3d half_;
  Random& random_;
  std::vector<PlacedPiece> placed_;
  std::vector<std::size_t> tables_;  ///< indices into placed_
};

}  // namespace planescope::synthesis
