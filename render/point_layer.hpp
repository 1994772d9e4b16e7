// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "point_colors.hpp"
#include "scene_data.hpp"
#include "viewpoint.hpp"

/// \file The cloud's points as one actor: uploaded once, recoloured at will.
namespace planescope::draw {

/// How large points are drawn.
struct PointScale {
  double pixels_per_metre_at_1m =
      0;             ///< (parallel: anywhere) of the picture that is drawn, before it is shrunk
  double fixed = 0;  ///< [pixel of the picture that is drawn] 0: by spacing
  double least = 1, most = 64;  ///< [pixel of the picture that is drawn]
  double round_from = 0;   ///< [pixel of the picture that is drawn] where splats are usually as
                           ///< large, they are discs: corners show; 0: never
  double usual_depth = 1;  ///< [m] of the points; parallel: 1
};

/// Points, each a square splat of 1.7 times the local spacing of the points, sqrt(area / points) of
/// its patch, seen in perspective, or a disc of the same area: surfaces close near and far,
/// whatever the sensor's density there. Patches of a few points are no surface, and their points
/// small.
class PointLayer {
 public:
  /// `points`: indices of those that are drawn; they must be finite.
  PointLayer(const SceneData& scene, const PointPainter& painter,
             std::vector<std::uint32_t> points);

  vtkActor* actor() { return actor_; }
  /// Colours the points this way from now on.
  void show(const PointColors& colors);
  /// Gives them colours from elsewhere, one a point of the cloud, toned as segments are.
  void show(const std::vector<Pixel>& colors);
  void scale(const PointScale& scale);

 private:
  void add_points();
  vtkSmartPointer<vtkFloatArray> splats();

  const SceneData& scene_;
  const PointPainter& painter_;
  std::vector<std::uint32_t> points_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkActor> actor_;
  double usual_splat_ = 0;  // [m]
};

/// Indices of all finite points that are not cut away.
std::vector<std::uint32_t> visible_points(const SceneData& scene, const Cutaway& cut);

/// Makes an actor's vertices squares of `splat` (a point array of diameters [m], or "" for a fixed
/// size), clamped as set by set_point_scale().
void use_splats(vtkActor& actor, vtkPolyDataMapper& mapper, const char* splat);
void set_point_scale(vtkActor& actor, const PointScale& scale);

/// Discs instead of squares, of the same diameter, or squares again. Squares are drawn faster.
enum class SplatShape { Square, Disc };
void use_shape(vtkActor& actor, SplatShape shape);

}  // namespace planescope::draw
