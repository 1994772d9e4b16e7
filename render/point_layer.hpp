// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "point_colors.hpp"
#include "scene_data.hpp"
#include "splats.hpp"
#include "viewpoint.hpp"

/// \file The cloud's points as one actor: uploaded once, recoloured at will.
namespace planescope::draw {

/// Points, each a square or disc on the screen.
class PointLayer {
 public:
  /// `points`: indices of those that are drawn; they must be finite. `diameters`: of each [m].
  PointLayer(const SceneData& scene, PointPainter& painter, std::vector<std::uint32_t> points,
             const std::vector<float>& diameters);

  vtkActor* actor() { return actor_; }
  /// [m] Of the points' middles.
  Eigen::AlignedBox3d bounds() const;
  /// Colours the points this way from now on.
  void show(const PointColors& colors);
  /// Gives them colours from elsewhere, one a point of the cloud, toned as segments are.
  void show(const std::vector<Pixel>& colors);
  void scale(const PointScale& scale);

 private:
  void add_points();

  const SceneData& scene_;
  PointPainter& painter_;
  std::vector<std::uint32_t> points_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkActor> actor_;
};

/// Indices of all finite points that are not cut away.
std::vector<std::uint32_t> visible_points(const SceneData& scene, const Cutaway& cut);

/// Makes an actor's vertices squares of `splat` (a point array of diameters [m], or "" for a fixed
/// size), clamped as set by set_point_scale().
void use_splats(vtkActor& actor, vtkPolyDataMapper& mapper, const char* splat);
void set_point_scale(vtkActor& actor, const PointScale& scale);

/// Discs of the same diameter instead of squares, or squares again.
void use_shape(vtkActor& actor, SplatShape shape);

}  // namespace planescope::draw
