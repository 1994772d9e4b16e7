// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
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
#include "shot.hpp"
#include "window.hpp"

/// \file One scene in one window, drawn as often as wanted: points are uploaded once, for the first
/// picture, which should be the largest: clouds are thinned to what it can show.
namespace planescope::draw {

/// Draws a scene's layers from one viewpoint. Two renderers share the picture: the points, shaded
/// by depth; over them, tested against the points' depth and not shaded, planes, graph and words.
class Drawing {
 public:
  /// `scene` must outlive the drawing. \param window to draw in; null: a new one.
  /// \throws Error{Kind::Usage} options are out of range, or the scene lacks what they name.
  /// \throws Error{Kind::Input} nothing in the scene is finite.
  /// \throws Error{Kind::Rendering} no OpenGL context.
  Drawing(const SceneData& scene, const RenderOptions& options, Fit fit = Fit::Scene,
          std::unique_ptr<Window> window = nullptr);

  /// A picture of some layers, its points coloured as `by` says. Where neither asks for colours,
  /// faded points lie under the others. What the options ask for is added to the annotation, and a
  /// note of what was cut away, if there are other words.
  /// \throws Error{Kind::Rendering} it would be uniform where the scene is, or VTK fails.
  Image draw(Layer layers, const std::array<int, 2>& size, Annotation annotation,
             ColorBy by = ColorBy::Layers);

  /// A picture of the points in given colours, one a point, shaded as segments are; no words.
  /// \throws as draw().
  Image draw_colored(const std::vector<Pixel>& colors, const std::array<int, 2>& size);

  /// The same with words, and with `shapes` over the points.
  Image draw_marked(const std::vector<Pixel>& colors, const std::array<int, 2>& size,
                    Annotation annotation, const Actors& shapes);

  /// From now on a picture may be uniform: a camera that goes its own way may see nothing.
  void allow_uniform() { uniform_allowed_ = true; }

  /// The camera of the picture that was drawn last.
  const Camera& camera() const { return eye_; }
  const Shot& shot() const { return shot_; }
  const SceneColors& colors() const { return colors_; }

 private:
  void make_renderers();
  void upload(const std::array<int, 2>& size, int scale);
  Camera camera(const Layout& layout) const;
  void complete(Annotation& annotation, Layer layers, const PointColors& colors,
                const std::array<int, 2>& size) const;
  void mark(Annotation& annotation, const Layout& layout) const;
  PointScale point_scale(const std::array<int, 2>& size, int scale) const;
  void show(Layer layers, const PointColors& colors, const Layout& layout, int scale);
  Image picture(const std::array<int, 2>& size, int scale, const Annotation& annotation,
                const Layout& layout);
  int supersample(const std::array<int, 2>& size) const;

  const SceneData& scene_;
  RenderOptions options_;
  bool uniform_allowed_ = false;
  Shot shot_;
  SceneColors colors_;
  std::unique_ptr<Window> window_;
  vtkSmartPointer<vtkRenderer> points_renderer_, shapes_renderer_;
  vtkSmartPointer<DepthShading> shading_;  // null without eye-dome lighting
  std::unique_ptr<PointPainter> painter_;
  std::unique_ptr<PointLayer> points_;
  Actors shapes_;
  Camera eye_;
  double usual_splat_ = 0;                            // [m]
  const std::vector<Pixel>* given_colors_ = nullptr;  // while draw_colored() runs
  Actors given_shapes_;                               // while draw_marked() runs
};

}  // namespace planescope::draw
