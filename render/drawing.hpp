// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "annotation.hpp"
#include "depth_shading.hpp"
#include "image.hpp"
#include "planescope/render.hpp"
#include "point_layer.hpp"
#include "scene_data.hpp"
#include "shape_layers.hpp"
#include "viewpoint.hpp"
#include "window.hpp"

/// \file One scene in one window, drawn as often as wanted: points are uploaded once.
namespace planescope::draw {

/// Draws a scene's layers from one viewpoint. Two renderers share the picture: the points, shaded
/// by depth; over them, tested against the points' depth and not shaded, planes, graph and words.
class Drawing {
 public:
  /// `scene` must outlive the drawing.
  /// \throws Error{Kind::Usage} size, supersampling or background are out of range.
  /// \throws Error{Kind::Input} nothing in the scene is finite.
  /// \throws Error{Kind::Rendering} no OpenGL context.
  Drawing(const SceneData& scene, const RenderOptions& options);

  /// A picture of some layers. Where no layer of points is asked for, faded points lie under the
  /// others. A note says what was cut away, if there are other words.
  /// \throws Error{Kind::Rendering} it would be uniform where the scene is, or VTK fails.
  Image draw(Layer layers, const std::array<int, 2>& size, Annotation annotation);

  /// A picture of the points in given colours, one a point, shaded as segments are; no words.
  /// \throws as draw().
  Image draw_colored(const std::vector<Pixel>& colors, const std::array<int, 2>& size);

  /// The camera of a picture of this size.
  Camera camera(const Layout& layout) const;

 private:
  void show(Layer layers, const Camera& camera, const Layout& layout, int scale);
  void color_points(Layer layers);
  int supersample(const std::array<int, 2>& size) const;

  const SceneData& scene_;
  RenderOptions options_;
  SceneFrame frame_;
  Viewpoint view_;
  SceneColors colors_;
  std::vector<Eigen::Vector3f> fitted_;  // a sample of the points that must be in the picture
  Cutaway cut_;
  Window window_;
  vtkSmartPointer<vtkRenderer> points_renderer_, shapes_renderer_;
  vtkSmartPointer<DepthShading> shading_;  // null without eye-dome lighting
  std::unique_ptr<PointLayer> points_;
  const std::vector<Pixel>* given_colors_ = nullptr;  // while draw_colored() runs
};

/// Checks what Drawing needs of the options. \throws Error{Kind::Usage}
void validate(const RenderOptions& options);

}  // namespace planescope::draw
