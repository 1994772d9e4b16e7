// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace planescope::synthesis {
namespace {

constexpr double kClearance = 0.015;  // [m] between pieces
constexpr double kQuarter = std::numbers::pi / 2;
constexpr double kDegree = std::numbers::pi / 180;

Isometry3d upright(double x, double y, double z, double yaw) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(x, y, z);
  pose.rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()));
  return pose;
}

Box3d bounds_of(const Piece& piece, const Isometry3d& pose) {
  Box3d box;
  for (const Part& part : piece.parts) {
    Solid solid = part.solid;
    solid.pose = pose * solid.pose;
    box.extend(solid.bounds());
  }
  return box;
}

// A table's first part is its top.
const Solid& top_of(const Piece& table) { return table.parts.front().solid; }

}  // namespace

bool Placement::fits(const Piece& piece, const Isometry3d& pose,
                     std::optional<std::size_t> support) const {
  const Box3d box = bounds_of(piece, pose);
  const bool inside = std::abs(box.min().x()) <= half_.x() &&
                      std::abs(box.max().x()) <= half_.x() &&
                      std::abs(box.min().y()) <= half_.y() &&
                      std::abs(box.max().y()) <= half_.y() && box.max().z() <= 2 * half_.z();
  if (!inside) return false;
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    if (i == support) continue;  // it stands on it, and touches
    for (const Part& other : placed_[i].piece.parts) {
      Solid obstacle = other.solid;
      obstacle.pose = placed_[i].pose * obstacle.pose;
      for (const Part& part : piece.parts) {
        Solid mine = part.solid;
        mine.pose = pose * mine.pose;
        if (boxes_collide(mine, obstacle, kClearance)) return false;
      }
    }
  }
  return true;
}

// `propose` gives a pose and, for what stands on a table, the index of that table.
bool Placement::try_poses(const Piece& piece, int attempts, auto&& propose) {
  for (int i = 0; i < attempts; ++i) {
    const std::pair<Isometry3d, std::optional<std::size_t>> proposal = propose();
    if (!fits(piece, proposal.first, proposal.second)) continue;
    if (piece.kind == "table") tables_.push_back(placed_.size());
    placed_.push_back({piece, proposal.first});
    return true;
  }
  return false;
}

bool Placement::place_at_wall(const Piece& piece) {
  const Box3d own = bounds_of(piece, Isometry3d::Identity());
  return try_poses(piece, 200, [&] {
    const double yaw = random_.integer(0, 3) * kQuarter;
    const Vector2d outwards(-std::sin(yaw), std::cos(yaw)), along(std::cos(yaw), std::sin(yaw));
    const double wall = outwards.cwiseAbs().dot(half_.head<2>());
    const double side = along.cwiseAbs().dot(half_.head<2>()) - own.max().x() - 0.02;
    // A hair's breadth instead of zero keeps rounding from pushing it into the wall.
    const double gap = random_.chance(0.4) ? 1e-6 : random_.uniform(0.01, 0.03);
    const Vector2d place =
        (wall - own.max().y() - gap) * outwards + random_.uniform(-side, side) * along;
    return std::pair(upright(place.x(), place.y(), 0, yaw), std::optional<std::size_t>());
  });
}

bool Placement::place_on_floor(const Piece& piece, bool square) {
  return try_poses(piece, 200, [&] {
    const double turn = square && random_.chance(0.75) ? random_.integer(0, 3) * kQuarter
                                                       : random_.uniform(0, 4 * kQuarter);
    const double x = random_.uniform(-half_.x(), half_.x());
    const double y = random_.uniform(-half_.y(), half_.y());
    return std::pair(upright(x, y, 0, turn), std::optional<std::size_t>());
  });
}

bool Placement::place_at_table(const Piece& chair) {
  if (tables_.empty()) return false;
  return try_poses(chair, 60, [&] {
    const std::size_t pick = tables_.size() > 1 && random_.chance(0.4) ? 1 : 0;
    const PlacedPiece& table = placed_[tables_[pick]];
    const Vector3d reach = top_of(table.piece).half;
    const bool rear = random_.chance(0.5);
    const double away = reach.y() + random_.uniform(0.0, 0.35);
    const double x = random_.uniform(-reach.x() + 0.25, reach.x() - 0.25);
    const double turn = (rear ? 0 : 2 * kQuarter) + 12 * kDegree * random_.normal();
    const Isometry3d seat = upright(x, rear ? away : -away, 0, turn);
    return std::pair<Isometry3d, std::optional<std::size_t>>(table.pose * seat, std::nullopt);
  });
}

bool Placement::place_on_table(const Piece& piece) {
  if (tables_.empty()) return false;
  const Box3d own = bounds_of(piece, Isometry3d::Identity());
  const double radius = own.sizes().head<2>().norm() / 2;
  return try_poses(piece, 60, [&] {
    const std::size_t pick =
        static_cast<std::size_t>(random_.integer(0, static_cast<int>(tables_.size()) - 1));
    const PlacedPiece& table = placed_[tables_[pick]];
    const Solid& top = top_of(table.piece);
    const Vector2d reach = (top.half.head<2>().array() - radius).cwiseMax(0.0);
    const double x = random_.uniform(-reach.x(), reach.x());
    const double y = random_.uniform(-reach.y(), reach.y());
    const double z = top.pose.translation().z() + top.half.z();
    const Isometry3d stand = upright(x, y, z, random_.uniform(0, 4 * kQuarter));
    return std::pair(table.pose * stand, std::optional<std::size_t>(tables_[pick]));
  });
}

}  // namespace planescope::synthesis
