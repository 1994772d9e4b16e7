// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/camera.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <set>

namespace planescope::synthesis {
namespace {

constexpr std::uint64_t kPlacing = 4;  // stream of the seed
constexpr double kDegree = std::numbers::pi / 180;

// The middle of each piece of furniture, by label.
std::vector<Vector3d> find_targets(const Room& room) {
  std::vector<Box3d> boxes(room.scene.objects().size());
  for (const Surface& surface : room.scene.surfaces()) {
    boxes[surface.label - 1].extend(surface.geometry.bounds());
  }
  std::vector<Vector3d> targets;
  for (std::size_t k = room.structures; k < boxes.size(); ++k) targets.push_back(boxes[k].center());
  return targets;
}

Isometry3d propose_pose(const Room& room, const Vector3d& target, Random& random) {
  constexpr double kWallClearance = 0.3, kClearance = 0.25;  // [m]
  Vector3d eye = Vector3d::Zero();
  for (int attempt = 0; attempt < 200; ++attempt) {
    const double reach_x = room.half.x() - kWallClearance, reach_y = room.half.y() - kWallClearance;
    const double x = random.uniform(-reach_x, reach_x), y = random.uniform(-reach_y, reach_y);
    eye = room.frame * Vector3d(x, y, random.uniform(1.2, 1.8));
    const double distance = (target - eye).head<2>().norm();
    if (distance > 1.0 && distance < 4.5 && !room.scene.occupied(eye, kClearance)) break;
  }
  const Vector3d towards = target - eye;
  const double yaw = std::atan2(towards.y(), towards.x()) + random.uniform(-12, 12) * kDegree;
  const double pitch = random.uniform(10, 35) * kDegree;
  return aim(eye, yaw, pitch, random.uniform(-3, 3) * kDegree);
}

// How much a pose shows: pieces of furniture seen, then the share of rays that return.
double rate(const Room& room, const RayCaster& caster, const Camera& camera) {
  constexpr int kStep = 24;  // [pixel]
  std::set<std::uint32_t> pieces;
  int rays = 0, returns = 0;
  for (int row = kStep / 2; row < camera.height; row += kStep) {
    for (int column = kStep / 2; column < camera.width; column += kStep, ++rays) {
      const Hit hit = caster.cast(camera.ray(column, row));
      if (hit.t < kNearest || hit.t > kFarthest) continue;
      ++returns;
      const std::uint32_t label =
          room.scene.surfaces()[static_cast<std::size_t>(hit.surface)].label;
      if (label > room.structures) pieces.insert(label);
    }
  }
  return static_cast<double>(pieces.size()) + 10.0 * returns / rays;
}

}  // namespace

Isometry3d aim(const Vector3d& eye, double yaw, double pitch, double roll) {
  const Vector3d forward(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch),
                         -std::sin(pitch));
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() = eye;
  pose.rotate(Eigen::AngleAxisd(roll, Vector3d::UnitZ()));
  return pose;
}

Ray Camera::ray(double column, double row) const {
  const Vector3d local((column - cx) / focal, (row - cy) / focal, 1);
  return {pose.translation(), pose.linear() * local};
}

DepthView render_depth(const RayCaster& caster, const Camera& camera) {
  const auto columns = static_cast<std::size_t>(camera.width);
  const auto rows = static_cast<std::size_t>(camera.height);
  DepthView view;
  view.depth.assign(columns * rows, 0);
  view.surface.assign(columns * rows, kNone);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Hit hit =
          caster.cast(camera.ray(static_cast<double>(column), static_cast<double>(row)));
      if (hit.surface == kNone) continue;
      view.depth[row * columns + column] = static_cast<float>(hit.t);
      view.surface[row * columns + column] = hit.surface;
    }
  });
  return view;
}

std::vector<Camera> place_cameras(const Room& room, const RayCaster& caster, std::uint64_t seed,
                                  std::uint32_t count) {
  constexpr int kProposals = 12;
  const std::vector<Vector3d> targets = find_targets(room);
  std::vector<Camera> cameras(count);
  tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t k) {
    Random random(seed, {kPlacing, k});
    double best = -1;
    for (int i = 0; i < kProposals; ++i) {
      Camera camera;
      camera.pose = propose_pose(room, targets[k % targets.size()], random);
      const double rating = rate(room, caster, camera);
      if (rating > best) {
        best = rating;
        cameras[k] = camera;
      }
    }
  });
  return cameras;
}

}  // namespace planescope::synthesis
