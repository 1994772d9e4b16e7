// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/walk.hpp"

#include <cmath>
#include <numbers>

namespace planescope::synthesis {
namespace {

constexpr std::uint64_t kWalking = 6;  // stream of the seed
constexpr double kPi = std::numbers::pi;

/// An ellipse around the room's middle.
struct Path {
  double reach = 0;   ///< [1] of half the room
  double height = 0;  ///< [m]
  double start = 0;   ///< [rad]
};

Vector3d place(const Room& room, const Path& path, double angle) {
  return room.frame * Vector3d(path.reach * room.half.x() * std::cos(angle),
                               path.reach * room.half.y() * std::sin(angle),
                               path.height + 0.05 * std::sin(7 * angle));
}

/// The widest path, then the lowest, on which nothing is hit.
Path choose_path(const Room& room, Random& random) {
  constexpr double kClearance = 0.2;  // [m]
  constexpr int kSteps = 180;
  Path path;
  path.start = random.uniform(0, 2 * kPi);
  for (const double reach : {0.5, 0.4, 0.3, 0.2, 0.1}) {
    for (const double height : {1.4, 1.55, 1.7, 1.85, 2.0}) {
      path.reach = reach;
      path.height = height;
      bool free = true;
      for (int k = 0; k < kSteps && free; ++k) {
        free = !room.scene.occupied(place(room, path, 2 * kPi * k / kSteps), kClearance);
      }
      if (free) return path;
    }
  }
  return path;  // under the ceiling in the middle: hardly anything is that high
}

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

}  // namespace

std::vector<Camera> walk_through(const Room& room, std::uint64_t seed, std::uint32_t frames) {
  Random random(seed, {kWalking});
  const Path path = choose_path(room, random);
  std::vector<Camera> cameras(frames);
  for (std::uint32_t k = 0; k < frames; ++k) {
    const double t = frames > 1 ? k / (frames - 1.0) : 0;
    const double angle = path.start + 6 * kPi * t;
    const double outwards = smooth_step((t - 0.27) / 0.12);
    const double yaw = angle + kPi + kPi * outwards + 0.15 * std::sin(22 * kPi * t);
    // Outwards first along the walls' upper halves, then along what stands before them: walls that
    // furniture hides below hang together above it.
    const double lowered = smooth_step((t - 0.62) / 0.1);
    const double pitch = std::lerp(15 + 25 * std::sin(14 * kPi * t),
                                   -14 + 36 * lowered + 6 * std::sin(14 * kPi * t), outwards);
    const double roll = 3 * std::sin(17 * kPi * t) * kPi / 180;
    // The room's frame is turned about z.
    const Vector3d ahead = room.frame.linear() * Vector3d(std::cos(yaw), std::sin(yaw), 0);
    cameras[k].pose =
        aim(place(room, path, angle), std::atan2(ahead.y(), ahead.x()), pitch * kPi / 180, roll);
  }
  return cameras;
}

}  // namespace planescope::synthesis
