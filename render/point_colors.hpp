// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "color_assignment.hpp"
#include "image.hpp"
#include "palette.hpp"
#include "planescope/render.hpp"
#include "scene_data.hpp"

/// \file Which colour a point has.
namespace planescope::draw {

/// Ways to colour the points; combined layers are averaged.
struct PointColors {
  bool scene = false, patches = false, segments = false;
  bool faded = false;            ///< then made light grey, so that what lies over them is read
  ColorBy by = ColorBy::Layers;  ///< any other: that alone

  /// The name of the array that holds such colours.
  std::string name() const;
};

/// How the points of a picture with these layers are coloured.
PointColors point_colors(Layer layers, ColorBy by);

/// Colours of the things in a scene, decided once, so that all pictures agree.
struct SceneColors {
  std::vector<Pixel> segments;            ///< index = label - 1
  std::vector<Pixel> planes;              ///< index = plane
  std::vector<Pixel> patches;             ///< index = patch; empty until somebody asks
  std::vector<std::uint32_t> truth;       ///< of each point: 0, or an index into regions + 1
  std::vector<Pixel> regions;             ///< of the truth
  std::array<float, 2> heights = {0, 1};  ///< [m] lowest and highest along up
};

/// Segments that lie on planes get calm colours, objects vivid ones; what touches in the graph is
/// kept apart. A plane has the hue of the largest segment on it.
/// \param given colours that segments have already and keep; see assign_colors().
SceneColors choose_colors(const SceneData& scene, Palette palette = Palette::Standard,
                          const std::vector<std::optional<Pixel>>& given = {});

/// Colours of patches, such that those that touch differ. There are many: it takes a while.
std::vector<Pixel> patch_colors(const SceneData& scene, Palette palette);

/// The colours that a picture with these options has. \throws Error{Kind::Input} the folder that
/// they name is none; Error{Kind::Usage} it is of another cloud.
SceneColors scene_colors(const SceneData& scene, const RenderOptions& options);

/// Segments that touch: pairs of label - 1.
Neighbours segment_neighbours(const SceneData& scene);

/// Adds the colours of a truth: each region has that of the segment that overlaps it most.
/// \throws Error{Kind::Usage} it has another number of points than the scene.
void add_truth(SceneColors& colors, const SceneData& scene,
               const std::vector<std::uint32_t>& truth);

/// Lowest and highest along `up` [m], but for one percent at each end.
std::array<float, 2> height_range(const PointCloud& cloud, const Eigen::Vector3f& up);

/// Curvature of patches from 0 to the 95th percentile.
std::array<float, 2> curvature_range(const SceneData& scene);

/// Says the colour of each point. The scene and the colours must outlive it.
class PointPainter {
 public:
  /// `light`: direction towards a lamp that brightens patches that face it, by a little, so that
  /// the faces of a box differ in tone; zero: none. Own colours are never changed by it.
  PointPainter(const SceneData& scene, const SceneColors& colors, const Eigen::Vector3d& up,
               const Eigen::Vector3d& light);

  /// Works out what patches look like by this way, once.
  void prepare(ColorBy by);

  /// \pre prepare(way.by)
  Pixel operator()(std::size_t point, const PointColors& way) const;

  /// How bright the lamp makes the point's patch, in (0, 1].
  float tone(std::size_t point) const {
    const std::int32_t patch = scene_.result.point_patch[point];
    return patch == kNone ? 1.0F : tones_[static_cast<std::size_t>(patch)];
  }

 private:
  Pixel scene_color(std::size_t point) const;
  Pixel height(std::size_t point) const;
  /// The one colour that is asked for, and whether the lamp shines on it.
  std::pair<Pixel, bool> single(std::size_t point, ColorBy by) const;
  Pixel averaged(std::size_t point, const PointColors& way) const;

  const SceneData& scene_;
  const SceneColors& colors_;
  Eigen::Vector3f up_;
  std::vector<float> tones_;             // of each patch
  std::vector<Pixel> normals_, curved_;  // of each patch, once they are asked for
};

}  // namespace planescope::draw
