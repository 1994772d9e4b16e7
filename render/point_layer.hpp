// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "image.hpp"
#include "scene_data.hpp"
#include "viewpoint.hpp"

/// \file The cloud's points as one actor: uploaded once, recoloured at will.
namespace planescope::draw {

/// Ways to colour the points; combined ones are averaged.
struct PointColors {
  bool scene = false, patches = false, segments = false;
  bool faded = false;  ///< then made light grey, so that what lies over them is read

  /// The name of the array that holds such colours.
  std::string name() const;
};

/// Colours of the things in a scene, decided once, so that all pictures agree.
struct SceneColors {
  std::vector<Pixel> segments;  ///< index = label - 1
  std::vector<Pixel> planes;    ///< index = plane
  std::vector<Pixel> patches;   ///< index = patch
};

/// Segments that lie on planes get calm colours, objects vivid ones; what touches in the graph is
/// kept apart.
SceneColors choose_colors(const SceneData& scene);

/// How large points are drawn.
struct PointScale {
  double pixels_per_metre_at_1m = 0;  ///< of the picture that is drawn, before it is shrunk
  double fixed = 0;                   ///< [pixel of the picture that is drawn] 0: by spacing
  double least = 1, most = 64;        ///< [pixel of the picture that is drawn]
};

/// All finite points that are not cut away. Each is a square splat of 1.7 times the local spacing
/// of the points, sqrt(area / points) of its patch, seen in perspective: surfaces close near and
/// far, whatever the sensor's density there.
class PointLayer {
 public:
  /// `light`: direction towards a lamp that brightens patches that face it, by a little, so that
  /// the faces of a box differ in tone; zero: none. Own colours are never changed by it.
  PointLayer(const SceneData& scene, const SceneColors& colors, const Eigen::Vector3d& up,
             const Eigen::Vector3d& light, const Cutaway& cut);

  vtkActor* actor() { return actor_; }
  /// Colours the points this way from now on.
  void show(const PointColors& colors);
  /// Gives them colours from elsewhere, one a point of the cloud, toned as segments are.
  void show(const std::vector<Pixel>& colors);
  void scale(const PointScale& scale);

 private:
  Pixel scene_color(std::size_t point) const;
  Pixel color(std::size_t point, const PointColors& colors) const;
  void add_points(const Cutaway& cut);
  vtkSmartPointer<vtkFloatArray> splats() const;

  const SceneData& scene_;
  const SceneColors& colors_;
  Eigen::Vector3f up_;
  std::vector<float> tones_;           // of each patch
  float lowest_ = 0, highest_ = 1;     // [m] along up
  std::vector<std::uint32_t> points_;  // indices of those that are drawn
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkActor> actor_;
};

/// Makes an actor's vertices squares of `splat` (a point array of diameters [m], or "" for a fixed
/// size), clamped as set by set_point_scale().
void use_splats(vtkActor& actor, vtkPolyDataMapper& mapper, const char* splat);
void set_point_scale(vtkActor& actor, const PointScale& scale);

}  // namespace planescope::draw
