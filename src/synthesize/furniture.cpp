// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/furniture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace planescope::synthesis {
namespace {

constexpr std::array<Rgb, 4> kWoods = {
    {{176, 132, 84}, {140, 96, 58}, {205, 170, 120}, {112, 76, 50}}};
constexpr std::array<Rgb, 6> kFabrics = {
    {{60, 90, 140}, {150, 60, 60}, {70, 120, 90}, {90, 80, 110}, {190, 140, 60}, {70, 75, 82}}};
constexpr std::array<Rgb, 6> kBrights = {
    {{214, 60, 50}, {40, 120, 190}, {240, 180, 40}, {60, 150, 80}, {150, 80, 160}, {235, 120, 50}}};
constexpr std::array<Rgb, 3> kCardboards = {{{186, 148, 104}, {168, 128, 86}, {198, 164, 122}}};
constexpr Rgb kWhite = {238, 236, 230};

Rgb pick(Random& random, std::span<const Rgb> colors) {
  return colors[static_cast<std::size_t>(random.integer(0, static_cast<int>(colors.size()) - 1))];
}

Rgb vary(Random& random, const Rgb& color) {
  const int by = random.integer(-10, 10);
  const auto channel = [by](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(value + by, 0, 255));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

Material wood(Random& random) {
  return {vary(random, pick(random, kWoods)), {}, Texture::Planks, random.uniform(0.08, 0.14)};
}

Solid solid(SolidShape shape, const Vector3d& centre, const Vector3d& size) {
  Solid made;
  made.shape = shape;
  made.pose.translation() = centre;
  made.half = size / 2;
  return made;
}

Part box(const std::string& name, const Vector3d& centre, const Vector3d& size,
         const Material& material) {
  return {solid(SolidShape::Box, centre, size), name, material};
}

// An upright cylinder that stands on z = bottom.
Part cylinder(const std::string& name, double bottom, double radius, double height,
              const Material& material) {
  return {
      solid(SolidShape::Cylinder, {0, 0, bottom + height / 2}, {2 * radius, 2 * radius, height}),
      name, material};
}

void add_legs(Piece& piece, const Vector2d& reach, double height, double thickness,
              const Material& material) {
  int number = 0;
  for (const double x : {-reach.x(), reach.x()}) {
    for (const double y : {-reach.y(), reach.y()}) {
      piece.parts.push_back(box("leg " + std::to_string(++number), {x, y, height / 2},
                                {thickness, thickness, height}, material));
    }
  }
}

Piece make_board_on_legs(Random& random, double width, double depth, double height) {
  const Material material = wood(random);
  Piece piece{"table", {}};
  const double thickness = random.uniform(0.025, 0.04), leg = random.uniform(0.04, 0.06);
  piece.parts.push_back(
      box("", {0, 0, height - thickness / 2}, {width, depth, thickness}, material));
  const Vector2d reach(width / 2 - leg / 2 - 0.02, depth / 2 - leg / 2 - 0.02);
  add_legs(piece, reach, height - thickness, leg, {material.base});
  return piece;
}

}  // namespace

Piece make_table(Random& random) {
  const double width = random.uniform(1.0, 1.5), depth = random.uniform(0.6, 0.8);
  return make_board_on_legs(random, width, depth, random.uniform(0.70, 0.76));
}

Piece make_coffee_table(Random& random) {
  const double width = random.uniform(0.8, 1.1), depth = random.uniform(0.5, 0.65);
  return make_board_on_legs(random, width, depth, random.uniform(0.40, 0.46));
}

Piece make_chair(Random& random) {
  const double width = random.uniform(0.38, 0.44), height = random.uniform(0.43, 0.47);
  const double seat = 0.035, leg = 0.035, back = random.uniform(0.38, 0.48);
  const Material fabric{vary(random, pick(random, kFabrics))}, frame = wood(random);
  Piece piece{"chair", {}};
  piece.parts.push_back(box("seat", {0, 0, height - seat / 2}, {width, width, seat}, fabric));
  add_legs(piece, Vector2d::Constant(width / 2 - leg / 2), height - seat, leg, {frame.base});
  Part rest = box("back", Vector3d::Zero(), {width, 0.025, back}, fabric);
  const double lean = random.uniform(4, 10) * std::numbers::pi / 180;
  const double clear = 0.0125 * std::sin(lean);  // of the rear edge, above the seat
  rest.solid.pose.translation() = Vector3d(0, width / 2 - 0.015, height + clear);
  rest.solid.pose.rotate(Eigen::AngleAxisd(-lean, Vector3d::UnitX()));
  rest.solid.pose.translate(Vector3d(0, 0, back / 2));
  piece.parts.push_back(rest);
  return piece;
}

Piece make_box(Random& random, double size) {
  const double x = random.uniform(0.8, 1.4), y = random.uniform(0.7, 1.1);
  const Vector3d edges = size * Vector3d(x, y, random.uniform(0.6, 1.1));
  const Rgb card = vary(random, pick(random, kCardboards));
  return {
      "box",
      {box("", {0, 0, edges.z() / 2}, edges, {card, {214, 190, 150}, Texture::Tape, size * 0.16})}};
}

Piece make_shelf(Random& random) {
  const double width = random.uniform(0.75, 1.0), depth = random.uniform(0.27, 0.34);
  const double height = random.uniform(1.6, 2.0), board = 0.022;
  const int boards = random.integer(5, 6);
  const Material material = wood(random);
  Piece piece{"shelf", {}};
  const double inner = width - 2 * board, deep = depth - board;
  for (const double side : {-1.0, 1.0}) {
    piece.parts.push_back(box(side < 0 ? "left side" : "right side",
                              {side * (width - board) / 2, 0, height / 2}, {board, depth, height},
                              {material.base}));
  }
  piece.parts.push_back(box("rear", {0, (depth - board) / 2, height / 2}, {inner, board, height},
                            {vary(random, material.base)}));
  for (int i = 0; i < boards; ++i) {
    const double z = board / 2 + (height - board) * i / (boards - 1);
    piece.parts.push_back(box("board " + std::to_string(i + 1), {0, -board / 2, z},
                              {inner, deep, board}, {material.base}));
  }
  return piece;
}

Piece make_bed(Random& random) {
  const double width = random.uniform(0.9, 1.5), length = random.uniform(1.95, 2.05);
  const double base = random.uniform(0.24, 0.32), mattress = random.uniform(0.16, 0.22);
  const Material frame = wood(random), cover{vary(random, pick(random, kFabrics))};
  Piece piece{"bed", {}};
  piece.parts.push_back(box("frame", {0, 0, base / 2}, {width, length, base}, {frame.base}));
  piece.parts.push_back(
      box("mattress", {0, 0, base + mattress / 2}, {width - 0.04, length - 0.04, mattress}, cover));
  const double head = random.uniform(0.85, 1.1);
  piece.parts.push_back(
      box("headboard", {0, length / 2 + 0.02, head / 2}, {width, 0.04, head}, frame));
  const int pillows = width > 1.25 ? 2 : 1;
  for (int i = 0; i < pillows; ++i) {
    const double x = pillows == 1 ? 0 : (i - 0.5) * width / 2;
    piece.parts.push_back(box("pillow " + std::to_string(i + 1),
                              {x, length / 2 - 0.28, base + mattress + 0.05}, {0.5, 0.34, 0.10},
                              {kWhite}));
  }
  return piece;
}

Piece make_cupboard(Random& random) {
  const double width = random.uniform(0.9, 1.3), depth = random.uniform(0.45, 0.58);
  const double height = random.uniform(1.75, 2.1), door = 0.018;
  const Material material = random.chance(0.5) ? wood(random) : Material{kWhite};
  Piece piece{"cupboard", {}};
  piece.parts.push_back(
      box("", {0, door / 2, height / 2}, {width, depth - door, height}, {material.base}));
  for (const double side : {-1.0, 1.0}) {
    piece.parts.push_back(box(side < 0 ? "left door" : "right door",
                              {side * width / 4, (door - depth) / 2, height / 2},
                              {width / 2 - 0.006, door, height - 0.06}, material));
  }
  return piece;
}

Piece make_ball(Random& random, double radius) {
  const Rgb color = vary(random, pick(random, kBrights));
  const Material material{color, kWhite, Texture::Stripes, std::numbers::pi * radius / 3};
  return {
      "ball",
      {{solid(SolidShape::Sphere, {0, 0, radius}, Vector3d::Constant(2 * radius)), "", material}}};
}

Piece make_bin(Random& random) {
  const double radius = random.uniform(0.12, 0.18), height = random.uniform(0.28, 0.42);
  return {"bin", {cylinder("", 0, radius, height, {vary(random, pick(random, kFabrics))})}};
}

Piece make_cup(Random& random) {
  const double radius = random.uniform(0.035, 0.05), height = random.uniform(0.09, 0.14);
  return {"cup", {cylinder("", 0, radius, height, {vary(random, pick(random, kBrights))})}};
}

Piece make_lamp(Random& random) {
  const double height = random.uniform(1.2, 1.5), shade = random.uniform(0.22, 0.3);
  const Material metal{{90, 90, 95}}, cloth{{240, 224, 180}};
  return {"lamp",
          {cylinder("foot", 0, random.uniform(0.13, 0.17), 0.03, metal),
           cylinder("pole", 0.03, 0.018, height - 0.03, metal),
           cylinder("shade", height, random.uniform(0.16, 0.22), shade, cloth)}};
}

}  // namespace planescope::synthesis
