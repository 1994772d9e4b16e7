// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "close_up.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "depth_order.hpp"
#include "drawing.hpp"
#include "hull.hpp"
#include "planescope/error.hpp"
#include "provenance.hpp"
#include "sheets.hpp"

namespace planescope::draw {
namespace {

constexpr double kViewAngle = 30;     // [deg]
constexpr double kPanelShare = 0.34;  // of the picture's width

/// The scene without what lies outside of the ball.
SceneData within(const StoredScene& stored, const CloseUp& what) {
  SceneData scene = scene_data(stored.scene, stored.cloud, stored.input);
  const float radius = static_cast<float>(what.radius);
  const Eigen::Vector3f middle = what.middle.cast<float>();
  for (Eigen::Vector3f& p : scene.result.cloud.positions)
    if (!((p - middle).norm() <= radius)) p.setConstant(std::numeric_limits<float>::quiet_NaN());
  return scene;
}

/// Patches in colour, the others as a pale shade of their segment.
std::vector<Pixel> point_colors(const SceneData& scene, const CloseUp& what) {
  const SceneColors colors = choose_colors(scene);
  std::vector<Pixel> pixels(scene.result.cloud.size(), Pixel{225, 225, 225});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::int32_t patch = scene.result.point_patch[i];
    if (patch == kNone) continue;
    const auto found = what.patches.find(static_cast<std::uint32_t>(patch));
    const std::uint32_t label = scene.result.point_label[i];
    if (found != what.patches.end()) {
      pixels[i] = found->second;
    } else if (label != kNoSegment) {
      pixels[i] = lighten(colors.segments[label - 1], 0.72);
    }
  }
  return pixels;
}

/// How many other patches stand between the patches in colour and an eye in this direction.
double hidden(const StoredScene& stored, const CloseUp& what, const Eigen::Vector3d& towards) {
  const std::vector<Patch>& patches = stored.scene.graph.patches;
  const double width = 0.6 * static_cast<double>(stored.scene.graph.patch_size);
  std::vector<std::uint32_t> watched = what.watched;
  if (watched.empty())
    for (const auto& [id, color] : what.patches) watched.push_back(id);
  const std::size_t step = 1 + watched.size() / 40;
  double sum = 0;
  for (std::size_t i = 0; i < watched.size(); i += step) {
    const Patch& patch = patches[watched[i]];
    const Eigen::Vector3d p = patch.centroid.cast<double>();
    for (const Patch& other : patches) {
      const Eigen::Vector3d to = other.centroid.cast<double>() - p;
      const double along = to.dot(towards);
      if (along < 2 * width || (to + p - what.middle).norm() > what.radius) continue;
      if ((to - along * towards).norm() < width) sum += 1;
    }
    const double facing = patch.normal.cast<double>().dot(towards);
    if (facing < 0.15) sum += 3;                           // seen from behind
    if (facing > 0.88 && watched.size() == 2) sum += 0.6;  // its arrow points at the eye
  }
  return sum;
}

/// Directions about `towards`: itself tilted by 20 and 40 degrees all around.
Eigen::Vector3d clearest_direction(const StoredScene& stored, const CloseUp& what) {
  const auto [u, v] = plane_axes(what.towards);
  Eigen::Vector3d best = what.towards;
  double least = std::numeric_limits<double>::infinity();
  for (const double tilt : {35.0, 20.0, 50.0}) {
    for (int k = 0; k < 12; ++k) {
      const double turn = std::numbers::pi * k / 6, lean = tilt * std::numbers::pi / 180;
      const Eigen::Vector3d d = std::cos(lean) * what.towards +
                                std::sin(lean) * (std::cos(turn) * u + std::sin(turn) * v);
      const double up = d.dot(scene_up(stored.scene, stored.cloud).cast<double>());
      // Of equals one from above, at the first tilt.
      const double cost = hidden(stored, what, d) - 0.5 * up + (tilt == 35 ? 0 : 0.3);
      if (cost < least) least = cost, best = d;
    }
  }
  return best;
}

Camera camera_for(const StoredScene& stored, const CloseUp& what) {
  const Eigen::Vector3d towards = clearest_direction(stored, what);
  Camera camera;
  camera.view_angle = kViewAngle;
  camera.focal = what.middle;
  const double half = kViewAngle / 2 * std::numbers::pi / 180;
  camera.position = what.middle + towards * (0.86 * what.radius / std::sin(half));
  camera.up = level(scene_up(stored.scene, stored.cloud).cast<double>(), towards);
  return camera;
}

std::vector<Mark> marks(const CloseUp& what, const Camera& camera, double aspect) {
  std::vector<Mark> all;
  for (const Tag& tag : what.tags) {
    const Eigen::Vector3d seen = project(camera, aspect, tag.place);
    if (seen.z() > 0) all.push_back({tag.text, {seen.x(), seen.y()}});
  }
  return all;
}

void check(const CloseUpOptions& options) {
  if (options.size[0] < 320 || options.size[1] < 200)
    throw Error(Error::Kind::Usage, "close-up size " + std::to_string(options.size[0]) + "x" +
                                        std::to_string(options.size[1]) +
                                        ": must be 320x200 at least, to hold the numbers");
}

}  // namespace

Sheet outline(const StoredScene& stored, const Plane& plane,
              const std::vector<std::uint32_t>& patches, const Pixel& color) {
  const Eigen::Vector3d normal = plane.normal.cast<double>();
  const auto [u, v] = plane_axes(normal);
  std::vector<Eigen::Vector2d> places;
  const double margin = 0.5 * static_cast<double>(stored.scene.graph.patch_size);
  for (const std::uint32_t id : patches) {
    const Eigen::Vector3d c = stored.scene.graph.patches[id].centroid.cast<double>();
    for (const auto& [s, t] : {std::pair{1, 1}, {1, -1}, {-1, -1}, {-1, 1}})
      places.emplace_back(c.dot(u) + s * margin, c.dot(v) + t * margin);
  }
  Sheet sheet{{}, normal, color};
  const auto hull = convex_hull(std::move(places));
  for (const Eigen::Vector2d& corner : hull)
    sheet.corners.push_back(corner.x() * u + corner.y() * v +
                            static_cast<double>(plane.distance) * normal);
  return sheet;
}

void draw(const StoredScene& stored, const CloseUp& what, const CloseUpOptions& options,
          const std::filesystem::path& png) {
  check(options);
  const SceneData scene = within(stored, what);
  RenderOptions drawing;
  const int panel_width = static_cast<int>(kPanelShare * options.size[0]);
  drawing.size = {options.size[0] - panel_width, options.size[1]};
  drawing.supersample = options.supersample;
  drawing.cull_front = false;
  const Camera camera = camera_for(stored, what);
  drawing.camera.fixed = in_world(camera, scene);
  Drawing view(scene, drawing);
  Actors extras = sheet_actors(what.sheets, camera, 2.0 * options.supersample,
                               0.4 * static_cast<double>(stored.scene.graph.patch_size));
  if (what.solids.size() > 0) extras.push_back(what.solids.actor());
  Annotation words;
  words.marks = marks(what, camera, static_cast<double>(drawing.size[0]) / drawing.size[1]);
  const Image picture = view.draw_marked(point_colors(scene, what), drawing.size, words, extras);
  Image whole = filled(options.size[0], options.size[1], {255, 255, 255});
  paste(whole, picture, 0, 0);
  paste(whole, draw_panel(what.panel, panel_width, options.size[1], options.supersample),
        drawing.size[0], 0);
  write_png(whole, png, provenance(scene, drawing, Layer::Segments, in_world(camera, scene)));
}

}  // namespace planescope::draw
