// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/room.hpp"

#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "planescope/error.hpp"
#include "synthesize/furniture.hpp"
#include "synthesize/placement.hpp"

namespace planescope::synthesis {
namespace {

enum Stream : std::uint64_t { kShell = 1, kFurniture = 2 };

// Tries `wanted` times; true if at least `needed` found a place.
bool place_some(int wanted, int needed, auto&& place) {
  int placed = 0;
  for (int i = 0; i < wanted; ++i) placed += place(i) ? 1 : 0;
  return placed >= needed;
}

bool place_large(Placement& placement, Random& random, bool small_room) {
  if (!placement.place_at_wall(make_bed(random))) return false;
  if (!placement.place_at_wall(make_cupboard(random))) return false;
  const auto shelf = [&](int) { return placement.place_at_wall(make_shelf(random)); };
  if (!place_some(small_room ? 1 : random.integer(1, 2), 1, shelf)) return false;
  const auto table = [&](int i) {
    if (i == 0) return placement.place_on_floor(make_table(random), true);
    if (i == 1) return placement.place_at_wall(make_table(random));
    return placement.place_on_floor(make_coffee_table(random), true);
  };
  return place_some(small_room ? 2 : random.integer(2, 3), 2, table);
}

bool place_small(Placement& placement, Random& random, bool small_room) {
  const auto chair = [&](int) {
    const Piece piece = make_chair(random);
    return (random.chance(0.75) && placement.place_at_table(piece)) ||
           placement.place_on_floor(piece, false);
  };
  const auto cylinder = [&](int i) {
    const int kind = i < 2 ? i : random.integer(0, 2);
    if (kind == 0) return placement.place_on_floor(make_bin(random), false);
    if (kind == 1) return placement.place_on_table(make_cup(random));
    return placement.place_on_floor(make_lamp(random), false);
  };
  const auto box = [&](int i) {
    return i % 2 == 0
               ? placement.place_on_floor(make_box(random, random.uniform(0.25, 0.42)), false)
               : placement.place_on_table(make_box(random, random.uniform(0.14, 0.24)));
  };
  const auto ball = [&](int i) {
    return i % 2 == 0
               ? placement.place_on_floor(make_ball(random, random.uniform(0.1, 0.18)), false)
               : placement.place_on_table(make_ball(random, random.uniform(0.05, 0.09)));
  };
  return place_some(random.integer(3, small_room ? 4 : 6), 3, chair) &&
         place_some(random.integer(2, 4), 2, cylinder) &&
         place_some(random.integer(4, 8), 4, box) && place_some(random.integer(2, 4), 2, ball);
}

// A small room can be blocked by how its bed and tables fell: then all starts anew.
std::vector<PlacedPiece> furnish(std::uint64_t seed, const Vector3d& half) {
  const bool small_room = 4 * half.x() * half.y() < 20;
  for (std::uint64_t attempt = 0; attempt < 1000; ++attempt) {
    Random random(seed, {kFurniture, attempt});
    Placement placement(half, random);
    if (place_large(placement, random, small_room) && place_small(placement, random, small_room)) {
      return placement.placed();
    }
  }
  throw Error(Error::Kind::Internal, "seed " + std::to_string(seed) +
                                         ": the furniture did not fit into the room; take another");
}

// A slab outside of the room whose own +z faces the inside.
Solid slab(const Isometry3d& frame, const Vector3d& face_centre, const Eigen::Matrix3d& turn,
           double half_x, double half_y) {
  constexpr double kHalfThickness = 0.1;
  Solid made;
  made.pose = frame;
  made.pose.translate(face_centre);
  made.pose.rotate(turn);
  made.pose.translate(Vector3d(0, 0, -kHalfThickness));
  made.half = Vector3d(half_x, half_y, kHalfThickness);
  return made;
}

void build_shell(Room& room, Random& random, bool ceiling) {
  using std::numbers::pi;
  const Vector3d& half = room.half;
  const Eigen::Matrix3d level = Eigen::Matrix3d::Identity();
  const Material tiles{{206, 192, 170}, {188, 172, 148}, Texture::Checker, 0.45};
  const Material boards{{178, 142, 102}, {}, Texture::Planks, 0.16};
  room.scene.add_structure(slab(room.frame, Vector3d::Zero(), level, half.x(), half.y()),
                           random.chance(0.5) ? tiles : boards, "floor");
  constexpr Rgb kPaints[] = {{232, 226, 212}, {214, 222, 226}, {226, 218, 224}, {222, 228, 214}};
  for (int i = 0; i < 4; ++i) {
    // The wall's own x runs along it, its y is up, its z looks into the room.
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(i * pi / 2, Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(pi / 2, Vector3d::UnitX()))
                                     .toRotationMatrix();
    const double reach = i % 2 == 0 ? half.y() : half.x();
    const double width = i % 2 == 0 ? half.x() : half.y();
    const Vector3d centre = -reach * turn.col(2) + Vector3d(0, 0, half.z());
    room.scene.add_structure(slab(room.frame, centre, turn, width, half.z()), {kPaints[i]},
                             "wall " + std::to_string(i + 1));
  }
  if (ceiling) {
    Eigen::Matrix3d down = level;
    down.col(1) *= -1;
    down.col(2) *= -1;
    room.scene.add_structure(slab(room.frame, {0, 0, 2 * half.z()}, down, half.x(), half.y()),
                             {{244, 243, 238}}, "ceiling");
  }
  room.structures = static_cast<std::uint32_t>(room.scene.objects().size());
}

}  // namespace

Room make_room(std::uint64_t seed, bool ceiling) {
  Random random(seed, {kShell});
  Room room;
  const double half_x = random.uniform(2.0, 3.5), half_y = random.uniform(1.75, 3.0);
  room.half = Vector3d(half_x, half_y, random.uniform(1.2, 1.4));
  room.frame =
      Isometry3d(Eigen::AngleAxisd(random.uniform(0, std::numbers::pi / 2), Vector3d::UnitZ()));
  build_shell(room, random, ceiling);
  std::map<std::string, int> number;
  for (const PlacedPiece& placed : furnish(seed, room.half)) {
    const std::string& kind = placed.piece.kind;
    const bool single = kind == "bed" || kind == "cupboard";
    const std::string name = single ? kind : kind + " " + std::to_string(++number[kind]);
    room.scene.add(placed.piece, room.frame * placed.pose, name);
  }
  return room;
}

}  // namespace planescope::synthesis
