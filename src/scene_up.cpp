// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "planescope/pipeline.hpp"

namespace planescope {
namespace {

// The larger the plane, the more it counts; planes outside the cone about the prior do not.
struct Candidate {
  Eigen::Vector3f up;
  float area = 0;
};

// The largest plane whose normal lies within the cone about `prior`. `either_side`: normals of maps
// may point down.
Candidate largest_level_plane(const Segmentation& scene, const Eigen::Vector3f& prior,
                              float min_cosine, bool either_side) {
  Candidate best{prior, 0};
  for (const SupportingPlane& plane : scene.planes) {
    const float cosine = plane.plane.normal.dot(prior);
    if ((either_side ? std::abs(cosine) : cosine) < min_cosine || plane.area <= best.area) continue;
    best = {cosine < 0 ? Eigen::Vector3f(-plane.plane.normal) : plane.plane.normal, plane.area};
  }
  return best;
}

// Indoors, things stand on the floor: more surface lies in the lower half of the height than in the
// upper.
bool upside_down(const Segmentation& scene, const Eigen::Vector3f& up) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  double area = 0, moment = 0;
  for (const Patch& patch : scene.graph.patches) {
    if (std::abs(patch.normal.dot(up)) > 0.5f)
      continue;  // sides of things, not floor against ceiling
    const float height = patch.centroid.dot(up);
    low = std::min(low, height);
    high = std::max(high, height);
    area += double(patch.area);
    moment += double(patch.area * height);
  }
  return area > 0 && moment / area > 0.5 * (double(low) + double(high));
}

// Up in the picture of a camera at the origin: -y in the usual camera frame (z forward, y down), +y
// where z points backwards (OpenGL's frame, in which some of PCL's clouds are stored).
Eigen::Vector3f picture_up(const Segmentation& scene) {
  double depth = 0;
  for (const Patch& patch : scene.graph.patches) depth += double(patch.area * patch.centroid.z());
  return depth < 0 ? Eigen::Vector3f::UnitY() : Eigen::Vector3f(-Eigen::Vector3f::UnitY());
}

}  // namespace

Eigen::Vector3f scene_up(const Segmentation& scene, const PointCloud& cloud) {
  if (cloud.organised()) {
    // Seen from the camera, what is level faces upwards however steeply the camera looks down (its
    // normal keeps a part along the picture's up), and what is upright never does.
    return largest_level_plane(scene, picture_up(scene), 0.34f, false).up;
  }
  if (cloud.up) return largest_level_plane(scene, *cloud.up, 0.85f, true).up;
  const Candidate z = largest_level_plane(scene, Eigen::Vector3f::UnitZ(), 0.9f, true);
  const Candidate y = largest_level_plane(scene, -Eigen::Vector3f::UnitY(), 0.9f, true);
  // Maps are mostly z-up; those in the frame of a first camera have y along the vertical and a wall
  // or none along z. A floor is larger than a wall, but in a narrow place.
  constexpr float kClearlyLarger = 1.5f;
  if (y.area <= kClearlyLarger * z.area) return z.up;
  return upside_down(scene, y.up) ? Eigen::Vector3f(-y.up) : y.up;
}

}  // namespace planescope
