// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "viewpoint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "hull.hpp"
#include "planescope/error.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

constexpr double kUpright = 0.25;  // |n . up| of walls is below: within 14 degrees
constexpr double kLevel = 0.97;    // |n . up| of ceilings is above: within 14 degrees
constexpr double kIsoPitch = 35;   // [deg]
constexpr double kViewAngle = 30;  // [deg] a long lens: parallels stay nearly so
constexpr double kBehind = 0.7, kBeyond = 0.8, kSpan = 0.6;  // shares of Cutaway's rule

/// A patch as its columns say it.
struct PatchView {
  Eigen::Vector3d centroid, normal;
  double area;
  std::int32_t plane;
};

std::vector<PatchView> patch_views(const SceneData& scene) {
  vtkPointData& columns = *scene.patches->GetPointData();
  vtkDataArray& normal = *columns.GetArray("normal");
  vtkDataArray& area = *columns.GetArray("area");
  vtkDataArray& plane = *columns.GetArray("plane");
  std::vector<PatchView> views;
  for (vtkIdType i = 0; i < scene.patches->GetNumberOfPoints(); ++i) {
    PatchView view;
    scene.patches->GetPoint(i, view.centroid.data());
    normal.GetTuple(i, view.normal.data());
    view.area = area.GetTuple1(i);
    view.plane = static_cast<std::int32_t>(plane.GetTuple1(i));
    views.push_back(view);
  }
  return views;
}

/// The sensor's position, where one is known or taken for granted.
std::optional<Eigen::Vector3d> sensor(const PointCloud& cloud) {
  if (cloud.sensor) return cloud.sensor->cast<double>();
  if (cloud.organised()) return Eigen::Vector3d(-cloud.origin);
  return std::nullopt;
}

Eigen::Vector3d centre(const std::vector<PatchView>& patches) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PatchView& patch : patches) sum += patch.centroid;
  return patches.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(patches.size()));
}

/// Patch area that faces somebody far away in this direction.
double facing_area(const std::vector<PatchView>& patches, const Eigen::Vector3d& towards) {
  double sum = 0;
  for (const PatchView& patch : patches)
    sum += patch.area * std::max(0.0, patch.normal.dot(towards));
  return sum;
}

Eigen::Vector3d iso_direction(const SceneData& scene, const SceneFrame& frame) {
  const std::vector<PatchView> patches = patch_views(scene);
  const double pitch = kIsoPitch * std::numbers::pi / 180;
  double best = -1;
  Eigen::Vector3d towards = frame.front;
  for (const auto& [front, right] : std::array<std::array<double, 2>, 4>{
           {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}}) {  // the first wins ties: the room is closed
    const Eigen::Vector3d level_part = (front * frame.front + right * frame.right()).normalized();
    const Eigen::Vector3d candidate = std::cos(pitch) * level_part + std::sin(pitch) * frame.up;
    const double area = facing_area(patches, candidate);
    if (area > best * (1 + 1e-6)) {
      best = area;
      towards = candidate;
    }
  }
  return -towards;
}

/// Extent of patches along an axis [m].
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double length() const { return std::max(high - low, 0.0); }
};

/// True if the plane's patches span most of the scene along both axes that lie most in it.
bool spans_scene(const std::vector<PatchView>& patches, std::int32_t index, const SceneFrame& frame,
                 const Eigen::Vector3d& normal) {
  int spanned = 0;
  for (const Eigen::Vector3d& axis : {frame.up, frame.front, frame.right()}) {
    if (std::abs(normal.dot(axis)) > 0.7) continue;
    Range own, all;
    for (const PatchView& patch : patches) {
      all.add(patch.centroid.dot(axis));
      if (patch.plane == index) own.add(patch.centroid.dot(axis));
    }
    if (own.length() > kSpan * all.length()) ++spanned;
  }
  return spanned == 2;
}

/// [m] Half the thickness of what lies in a plane.
float band(const SceneData& scene, const SupportingPlane& plane) {
  return static_cast<float>(std::max(3.0 * plane.rms, 2 * scene.result.voxel_size));
}

/// True if the plane with these patches stands between camera and scene.
bool stands_between(const std::vector<PatchView>& patches, std::int32_t index, const Plane& plane,
                    const SceneFrame& frame, const Eigen::Vector3d& camera, double band) {
  const double camera_side = plane.signed_distance(camera.cast<float>());
  double own = 0, behind = 0, others = 0, beyond = 0;
  for (const PatchView& patch : patches) {
    if (patch.plane == index) {
      own += patch.area;
      if (patch.normal.dot(camera - patch.centroid) < 0) behind += patch.area;
    } else {
      others += patch.area;
      const double side = plane.signed_distance(patch.centroid.cast<float>());
      if (side * camera_side < 0 || std::abs(side) < band) beyond += patch.area;
    }
  }
  // A wall hides a room; where there is less behind it than it is large itself, it is what was
  // scanned.
  if (own <= 0 || others < own) return false;
  if (beyond < kBeyond * others || std::abs(camera_side) <= band) return false;
  return behind >= kBehind * own || spans_scene(patches, index, frame, plane.normal.cast<double>());
}

}  // namespace

SceneFrame scene_frame(const SceneData& scene, const std::optional<Eigen::Vector3f>& up) {
  SceneFrame frame;
  frame.up = up.value_or(scene.result.up).cast<double>().normalized();
  Eigen::Vector3d wished = -Eigen::Vector3d::UnitY();
  if (const auto from = sensor(scene.result.cloud))
    wished = *from - centre(patch_views(scene));
  else if (std::abs(frame.up.y()) > std::abs(frame.up.z()))
    wished = -Eigen::Vector3d::UnitZ();
  wished = level(wished, frame.up);
  double largest = 0;
  Eigen::Vector3d wall = wished;
  for (const SupportingPlane& plane : scene.result.planes) {
    const Eigen::Vector3d normal = plane.plane.normal.cast<double>();
    if (std::abs(normal.dot(frame.up)) > kUpright || plane.area <= largest) continue;
    largest = plane.area;
    wall = level(normal, frame.up);
  }
  const Eigen::Vector3d side = frame.up.cross(wall);
  frame.front = wall;
  for (const Eigen::Vector3d& candidate : {Eigen::Vector3d(-wall), side, Eigen::Vector3d(-side)})
    if (candidate.dot(wished) > frame.front.dot(wished) + 1e-6) frame.front = candidate;
  return frame;
}

Camera Viewpoint::fit(const std::vector<Eigen::Vector3f>& points, double aspect, const Frame& frame,
                      Projection projection) const {
  if (projection == Projection::Parallel)
    return fit_parallel(points, forward, up, kViewAngle, aspect, frame);
  if (position) return fit_from(points, *position, up, aspect, frame);
  return fit_along(points, forward, up, kViewAngle, aspect, frame);
}

Viewpoint turned(const Viewpoint& view, const SceneFrame& frame, std::optional<double> azimuth,
                 std::optional<double> elevation) {
  if (!azimuth && !elevation) return view;
  constexpr double kDegree = std::numbers::pi / 180;
  const Eigen::Vector3d towards = -view.forward;  // where the camera stands
  const double height = std::asin(std::clamp(towards.dot(frame.up), -1.0, 1.0)) / kDegree;
  const bool level_view = std::abs(height) < 89;
  const double turn =
      level_view ? std::atan2(towards.dot(frame.right()), towards.dot(frame.front)) / kDegree : 0;
  const double a = azimuth.value_or(turn) * kDegree, e = elevation.value_or(height) * kDegree;
  const Eigen::Vector3d flat = std::cos(a) * frame.front + std::sin(a) * frame.right();
  const Eigen::Vector3d place = std::cos(e) * flat + std::sin(e) * frame.up;
  const bool upright = std::abs(place.dot(frame.up)) < 0.9999;
  const Eigen::Vector3d over = e > 0 ? Eigen::Vector3d(-flat) : flat;
  return {upright ? frame.up : over, -place, {}};
}

Viewpoint choose_view(View view, const SceneData& scene, const SceneFrame& frame) {
  if (view == View::Auto) view = scene.result.cloud.organised() ? View::Sensor : View::Iso;
  switch (view) {
    case View::Sensor: {
      const auto from = sensor(scene.result.cloud);
      if (!from) {
        throw Error(Error::Kind::Usage,
                    "view `sensor`: the cloud has no sensor position; take another view");
      }
      return {frame.up, (centre(patch_views(scene)) - *from).normalized(), from};
    }
    case View::Top:
      return {-frame.front, -frame.up, {}};
    case View::Front:
      return {frame.up, -frame.front, {}};
    case View::Left:
      return {frame.up, frame.right(), {}};
    case View::Iso:
    case View::Auto:
      break;
  }
  return {frame.up, iso_direction(scene, frame), {}};
}

Cutaway::Cutaway(const SceneData& scene, const SceneFrame& frame, const Eigen::Vector3d& camera) {
  const std::vector<PatchView> patches = patch_views(scene);
  const auto& planes = scene.result.planes;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const double slope = std::abs(planes[k].plane.normal.cast<double>().dot(frame.up));
    if (slope > kUpright && slope < kLevel) continue;
    if (planes[k].role == PlaneRole::Face) continue;  // a thing in the room, not its wall
    const auto index = static_cast<std::int32_t>(k);
    if (!stands_between(patches, index, planes[k].plane, frame, camera, band(scene, planes[k])))
      continue;
    add(scene, index);
  }
}

Cutaway::Cutaway(const SceneData& scene, const std::vector<std::int32_t>& planes) {
  const auto count = static_cast<std::int32_t>(scene.result.planes.size());
  for (const std::int32_t plane : planes) {
    if (plane < 0 || plane >= count)
      throw Error(Error::Kind::Usage, "cutaway: there is no plane " + std::to_string(plane) +
                                          "; the scene has " + std::to_string(count) +
                                          ", numbered from 0 in result.json");
    add(scene, plane);
  }
}

void Cutaway::add(const SceneData& scene, std::int32_t index) {
  const SupportingPlane& plane = scene.result.planes[static_cast<std::size_t>(index)];
  const auto [u, v] = plane_axes(plane.plane.normal.cast<double>());
  constexpr float kFar = std::numeric_limits<float>::infinity();
  Slab slab{index,
            plane.plane,
            u.cast<float>(),
            v.cast<float>(),
            Eigen::Vector2f::Constant(kFar),
            Eigen::Vector2f::Constant(-kFar),
            band(scene, plane)};
  for (const PatchView& patch : patch_views(scene)) {
    if (patch.plane != index) continue;
    const Eigen::Vector2f p(patch.centroid.dot(u), patch.centroid.dot(v));
    slab.low = slab.low.cwiseMin(p);
    slab.high = slab.high.cwiseMax(p);
  }
  const auto margin = static_cast<float>(scene.result.patch_size);
  slab.low.array() -= margin;
  slab.high.array() += margin;
  slabs_.push_back(slab);
}

bool Cutaway::hides(const Eigen::Vector3f& position, std::int32_t plane) const {
  for (const Slab& slab : slabs_) {
    if (plane == slab.plane) return true;
    if (plane != kNone) continue;
    const Eigen::Vector2f p(position.dot(slab.u), position.dot(slab.v));
    if (std::abs(slab.surface.signed_distance(position)) < slab.band &&
        (p.array() >= slab.low.array()).all() && (p.array() <= slab.high.array()).all())
      return true;
  }
  return false;
}

}  // namespace planescope::draw
