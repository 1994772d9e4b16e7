// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "fit_points.hpp"
#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// The finite points of one segment.
Points segment_points(const Result& result, std::uint32_t label) {
  Points points;
  for (std::size_t i = 0; i < result.cloud.size(); ++i)
    if (result.point_label[i] == label) points.push_back(result.cloud.positions[i]);
  if (points.empty())
    throw Error(Error::Kind::Usage, "fit: there is no segment " + std::to_string(label) +
                                        "; the scene has " +
                                        std::to_string(result.segments.size()));
  return points;
}

/// What points sweep when they are turned about the upright axis through their middle: for each of
/// some heights a ring of the largest radius.
Points swept(const Points& points, const SceneFrame& axes) {
  constexpr std::size_t kHeights = 48, kRing = 48;
  Eigen::AlignedBox3d box;  // along front, right and up
  const auto local = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3d d = p.cast<double>();
    return Eigen::Vector3d(d.dot(axes.front), d.dot(axes.right()), d.dot(axes.up));
  };
  for (const Eigen::Vector3f& p : points) box.extend(local(p));
  const Eigen::Vector3d middle = box.center();
  std::array<double, kHeights> radii{};
  const double step = std::max(box.sizes().z(), 1e-6) / (kHeights - 1);
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d q = local(p);
    const auto row = static_cast<std::size_t>(std::lround((q.z() - box.min().z()) / step));
    const double radius = std::hypot(q.x() - middle.x(), q.y() - middle.y());
    radii[row] = std::max(radii[row], radius);
  }
  Points rings;
  for (std::size_t row = 0; row < kHeights; ++row) {
    for (std::size_t k = 0; k < kRing; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kRing;
      const double front = middle.x() + radii[row] * std::cos(angle);
      const double right = middle.y() + radii[row] * std::sin(angle);
      const double up = box.min().z() + static_cast<double>(row) * step;
      rings.push_back((front * axes.front + right * axes.right() + up * axes.up).cast<float>());
    }
  }
  return rings;
}

}  // namespace

Shot::Shot(const SceneData& scene, const RenderOptions& options, Fit fit)
    : options_(options.camera) {
  const Eigen::Vector3d& origin = scene.result.cloud.origin;
  if (options_.fixed) {
    fixed_ = options_.fixed;
    fixed_->position -= origin;
    fixed_->focal -= origin;
  }
  if (options_.focal) focal_ = *options_.focal - origin;
  if (options_.fit) {
    fit_to(scene, scene_data(*options_.fit), options);
  } else {
    fit_to(scene, scene, options);
  }
  if (fit == Fit::Around) fitted_ = swept(fitted_, axes_);
}

void Shot::fit_to(const SceneData& scene, const SceneData& model, const RenderOptions& options) {
  axes_ = scene_frame(model, options.up);
  view_ =
      turned(choose_view(options.view, model, axes_), axes_, options_.azimuth, options_.elevation);
  const auto points = [&](const Cutaway& cut) {
    return options_.fit_segment == kNoSegment ? points_to_fit(model.result, axes_, cut)
                                              : segment_points(model.result, options_.fit_segment);
  };
  fitted_ = points({});
  const bool cuts = options.cull_front && (fixed_ || !view_.position);  // a sensor saw all it saw
  const double aspect = static_cast<double>(options.size[0]) / options.size[1];
  Cutaway own, models;
  if (!options.cutaway.empty()) {
    own = Cutaway(scene, options.cutaway);
  } else if (cuts) {
    const Eigen::Vector3d eye = camera(aspect, {}).eye();
    own = Cutaway(scene, axes_, eye);
    models = &model == &scene ? own : Cutaway(model, axes_, eye);
    fitted_ = points(models);
  }
  cut_ = own;
  const Eigen::Vector3d shift = model.result.cloud.origin - scene.result.cloud.origin;
  if (shift.isZero()) return;
  for (Eigen::Vector3f& p : fitted_) p += shift.cast<float>();
  if (view_.position) *view_.position += shift;
}

Camera Shot::camera(double aspect, const Frame& frame) const {
  if (fixed_) return *fixed_;
  const Projection projection = options_.parallel ? Projection::Parallel : Projection::Perspective;
  return adjusted(view_.fit(fitted_, aspect, frame, projection), focal_, options_.zoom,
                  options_.roll);
}

double azimuth(const Viewpoint& view, const SceneFrame& frame) {
  const Eigen::Vector3d towards = -view.forward;
  return std::atan2(towards.dot(frame.right()), towards.dot(frame.front)) * 180 / std::numbers::pi;
}

}  // namespace planescope::draw
