// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/views.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "synthesize/sampling.hpp"
#include "synthesize/seen_area.hpp"

namespace planescope::synthesis {
namespace {

constexpr std::uint64_t kSensing = 5;  // stream of the seed

// Probability that a return is lost, by the angle between ray and normal: smoothly from 0 at 75
// degrees to 1 at 90.
double grazing_loss(double cosine) {
  const double angle = std::acos(std::clamp(cosine, 0.0, 1.0)) * 180 / std::numbers::pi;
  const double x = std::clamp((angle - 75) / 15, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

// True where a neighbouring pixel shows another surface, more than 5 % nearer or farther away.
bool on_depth_edge(const DepthView& view, const Camera& camera, int column, int row) {
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(std::ptrdiff_t{y} * camera.width + x);
  };
  const std::size_t self = index(column, row);
  const auto breaks = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) return false;
    const std::size_t other = index(x, y);
    return view.surface[other] != view.surface[self] &&
           std::abs(view.depth[other] - view.depth[self]) > 0.05f * view.depth[self];
  };
  return breaks(column - 1, row) || breaks(column + 1, row) || breaks(column, row - 1) ||
         breaks(column, row + 1);
}

// The pixels of one row, each with its own share of the row's generator's numbers.
void sense_row(const Scene& scene, const Camera& camera, const DepthView& view,
               const SynthesisOptions& options, Random random, int row, PointCloud& cloud) {
  constexpr double kEdgeLoss = 0.5;
  for (int column = 0; column < camera.width; ++column) {
    const auto i = static_cast<std::size_t>(std::ptrdiff_t{row} * camera.width + column);
    if (view.surface[i] == kNone) continue;
    const Surface& surface = scene.surfaces()[static_cast<std::size_t>(view.surface[i])];
    const Ray ray = camera.ray(column, row);
    const double z = static_cast<double>(view.depth[i]);
    const SurfacePoint point = surface.geometry.at(ray.origin + z * ray.direction);
    cloud.colors[i] = shade(surface.material, point.texture, random);
    const double noisy = z + options.noise * z * z * random.normal();
    const bool lost = random.chance(grazing_loss(-ray.direction.normalized().dot(point.normal))) ||
                      (on_depth_edge(view, camera, column, row) && random.chance(kEdgeLoss));
    const bool in_range =
        z >= kNearest && z <= kFarthest && noisy >= kNearest && noisy <= kFarthest;
    if (lost || !in_range) continue;
    const Vector3d local((column - camera.cx) / camera.focal, (row - camera.cy) / camera.focal, 1);
    cloud.positions[i] = (noisy * local).cast<float>();
    cloud.labels[i] = surface.label;
    if (options.normals) {
      cloud.normals[i] = (camera.pose.linear().transpose() * point.normal).cast<float>();
    }
  }
}

// Moves the finite points of a camera's cloud into the room's frame, and adds them.
void append(const PointCloud& view, const Isometry3d& pose, PointCloud& cloud) {
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (!is_finite(view.positions[i])) continue;
    cloud.positions.push_back((pose * view.positions[i].cast<double>()).cast<float>());
    cloud.colors.push_back(view.colors[i]);
    cloud.labels.push_back(view.labels[i]);
    if (view.has_normals()) {
      cloud.normals.push_back((pose.linear() * view.normals[i].cast<double>()).cast<float>());
    }
  }
}

void move(PointCloud& cloud, const Vector3d& shift) {
  if (shift.isZero(0)) return;
  for (Eigen::Vector3f& p : cloud.positions) p = (p.cast<double>() + shift).cast<float>();
}

}  // namespace

PointCloud sense(const Scene& scene, const Camera& camera, const DepthView& view,
                 const SynthesisOptions& options, std::uint64_t stream) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  PointCloud cloud;
  const std::size_t pixels = view.depth.size();
  cloud.positions.assign(pixels, Eigen::Vector3f::Constant(kNan));
  cloud.colors.assign(pixels, Rgb{});
  cloud.labels.assign(pixels, kNoSegment);
  if (options.normals) cloud.normals.assign(pixels, Eigen::Vector3f::Constant(kNan));
  cloud.width = static_cast<std::uint32_t>(camera.width);
  cloud.height = static_cast<std::uint32_t>(camera.height);
  cloud.sensor = Eigen::Vector3f::Zero();
  tbb::parallel_for(0, camera.height, [&](int row) {
    const Random random(options.random_seed, {kSensing, stream, static_cast<std::uint64_t>(row)});
    sense_row(scene, camera, view, options, random, row, cloud);
  });
  return cloud;
}

std::vector<TruePlane> describe_seen(const Scene& scene, const SeenArea& seen,
                                     const Isometry3d& pose) {
  std::vector<TruePlane> planes;
  for (std::size_t s = 0; s < scene.surfaces().size(); ++s) {
    const VisiblePart part = seen.part(s);
    if (part.area > 0) planes.push_back(describe_plane(scene.surfaces()[s], part, pose));
  }
  return planes;
}

SynthesizedScene see_room(const Room& room, const SynthesisOptions& options,
                          const Vector3d& shift) {
  const RayCaster caster(room.scene);
  const std::vector<Camera> cameras =
      place_cameras(room, caster, options.random_seed, options.views);
  const bool single = cameras.size() == 1;
  SynthesizedScene made;
  made.objects = room.scene.objects();
  SeenArea seen(room.scene);
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    const DepthView depth = render_depth(caster, cameras[k]);
    PointCloud view = sense(room.scene, cameras[k], depth, options, k);
    seen.add(cameras[k], depth, view);
    if (single) {
      made.cloud = std::move(view);
      made.cloud.sensor = shift.cast<float>();
    } else {
      append(view, cameras[k].pose, made.cloud);
    }
  }
  if (!single) made.cloud.width = static_cast<std::uint32_t>(made.cloud.size());
  move(made.cloud, shift);
  const Eigen::Translation3d moved(shift.x(), shift.y(), shift.z());
  made.planes = describe_seen(room.scene, seen,
                              single ? moved * cameras.front().pose.inverse() : Isometry3d(moved));
  return made;
}

}  // namespace planescope::synthesis
