// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "camera.hpp"
#include "planescope/render.hpp"
#include "scene_data.hpp"

/// \file From where a scene is seen: the named views, and what is cut away so that they show the
/// inside of a room.
namespace planescope::draw {

/// The scene's own directions: unit, orthogonal.
struct SceneFrame {
  Eigen::Vector3d up;     ///< against gravity
  Eigen::Vector3d front;  ///< level, from the scene towards who stands before it: the wall normal
                          ///< nearest to the sensor's side, or to -y of a map
  Eigen::Vector3d right() const { return up.cross(front); }
};

/// Up is `up` or the result's own; front is a normal of the largest upright plane, so that rooms
/// stand straight in the picture.
SceneFrame scene_frame(const SceneData& scene, const std::optional<Eigen::Vector3f>& up);

enum class Projection { Perspective, Parallel };

/// A view, settled: either from a place, or along a direction.
struct Viewpoint {
  Eigen::Vector3d up;                       ///< of the picture
  Eigen::Vector3d forward;                  ///< direction of the view
  std::optional<Eigen::Vector3d> position;  ///< [m] of the sensor; else as near as the scene fits

  /// The camera for points that shall fill the frame; a parallel projection if `parallel`.
  Camera fit(const std::vector<Eigen::Vector3f>& points, double aspect, const Frame& frame,
             Projection projection = Projection::Perspective) const;
};

/// The view from where `azimuth` and `elevation` [deg] say (CameraOptions); what is not given stays
/// as it is in `view`. From straight above and below, up is what lies behind the scene's middle.
Viewpoint turned(const Viewpoint& view, const SceneFrame& frame, std::optional<double> azimuth,
                 std::optional<double> elevation);

/// Settles a view. Auto: Sensor for organised clouds, else Iso. Iso looks down by 35 degrees from
/// that corner of the four from which most patch area faces the camera. Sensor needs one: the
/// cloud's own, or the origin of an organised cloud.
/// \throws Error{Kind::Usage} the view is Sensor and there is none.
Viewpoint choose_view(View view, const SceneData& scene, const SceneFrame& frame);

/// What stands between camera and room and is left out: supporting planes that are upright, or a
/// ceiling, where (1) at least 80 % of the other patches' area lies beyond, and that area is larger
/// than the plane's own: there is a room behind, and (2) either at least
/// 70 % of the plane's patch area is seen from behind, for normals point to the side from which a
/// surface was scanned, or the plane spans 60 % of the scene both ways. At the place of an
/// organised cloud's sensor nothing is left out. With such a plane goes all that lies in it within
/// a band, such as pictures on a wall, unless it lies on another plane.
class Cutaway {
 public:
  Cutaway() = default;
  Cutaway(const SceneData& scene, const SceneFrame& frame, const Eigen::Vector3d& camera);

  /// These planes instead, whatever stands where.
  /// \throws Error{Kind::Usage} the scene has no such plane.
  Cutaway(const SceneData& scene, const std::vector<std::int32_t>& planes);

  bool any() const { return !slabs_.empty(); }
  /// True if what lies here, on this supporting plane or on none, is left out.
  bool hides(const Eigen::Vector3f& position, std::int32_t plane) const;

 private:
  struct Slab {
    std::int32_t plane = kNone;
    Plane surface;
    Eigen::Vector3f u, v;       // axes in the plane
    Eigen::Vector2f low, high;  // extent of its patches along them
    float band = 0;             // [m] half thickness
  };
  void add(const SceneData& scene, std::int32_t plane);

  std::vector<Slab> slabs_;
};

}  // namespace planescope::draw
