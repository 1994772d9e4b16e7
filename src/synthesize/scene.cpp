// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace planescope::synthesis {
namespace {

Rgb lighten(const Rgb& color, double by) {
  const auto channel = [by](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(std::round(value + by), 0.0, 255.0));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

// Spelled out: this is asked for every point and solid, in builds without optimisation too.
bool within(const Box3d& box, const Vector3d& p) {
  const double *low = box.min().data(), *high = box.max().data(), *x = p.data();
  return low[0] <= x[0] && x[0] <= high[0] && low[1] <= x[1] && x[1] <= high[1] && low[2] <= x[2] &&
         x[2] <= high[2];
}

bool odd(double x) { return (static_cast<std::int64_t>(std::floor(x)) & 1) != 0; }

// A face of a box: how its own axes lie in the box's frame.
struct BoxFace {
  const char* name;
  std::array<int, 3> axis;  // of the face's x, y, z
  std::array<int, 3> sign;
};
// Sides have y upwards, so that their patterns stand upright.
constexpr std::array<BoxFace, 6> kBoxFaces = {{{"top", {0, 1, 2}, {1, 1, 1}},
                                               {"bottom", {0, 1, 2}, {1, -1, -1}},
                                               {"right", {1, 2, 0}, {1, 1, 1}},
                                               {"left", {1, 2, 0}, {-1, 1, -1}},
                                               {"back", {0, 2, 1}, {-1, 1, 1}},
                                               {"front", {0, 2, 1}, {1, 1, -1}}}};

SurfaceGeometry box_face(const Solid& box, const BoxFace& face) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    turn(face.axis[k], i) = face.sign[k];
  }
  SurfaceGeometry geometry;
  geometry.pose = box.pose;
  geometry.pose.linear() = box.pose.linear() * turn;
  geometry.pose.translation() += geometry.normal() * box.half[face.axis[2]];
  geometry.a = box.half[face.axis[0]];
  geometry.b = box.half[face.axis[1]];
  return geometry;
}

}  // namespace

Rgb shade(const Material& material, const Vector2d& texture, Random& random) {
  const double x = texture.x() / material.period, y = texture.y() / material.period;
  double brightness = random.uniform(-5, 5);
  bool second = false;
  switch (material.texture) {
    case Texture::Plain:
      break;
    case Texture::Checker:
      second = odd(x) != odd(y);
      break;
    case Texture::Planks:
      brightness += 22 * std::sin(37.0 * std::floor(y)) - (y - std::floor(y) < 0.04 ? 40 : 0);
      break;
    case Texture::Stripes:
      second = odd(x);
      break;
    case Texture::Tape:
      second = std::abs(x) < 0.5;
      break;
  }
  return lighten(second ? material.second : material.base, brightness);
}

void Scene::add_solid(const Solid& solid) {
  const Box3d bounds = solid.bounds();
  const Vector3d gap = Vector3d::Constant(kHiddenGap);
  solids_.push_back(solid);
  reach_.emplace_back(bounds.min() - gap, bounds.max() + gap);
}

std::uint32_t Scene::add(const Piece& piece, const Isometry3d& pose, const std::string& name) {
  objects_.push_back(name);
  for (const Part& part : piece.parts) add_part(part, pose, name);
  return static_cast<std::uint32_t>(objects_.size());
}

std::uint32_t Scene::add_structure(const Solid& slab, const Material& material,
                                   const std::string& name) {
  objects_.push_back(name);
  add_solid(slab);
  Surface surface;
  surface.geometry = box_face(slab, kBoxFaces[0]);
  surface.material = material;
  surface.label = static_cast<std::uint32_t>(objects_.size());
  surface.solid = static_cast<std::uint32_t>(solids_.size() - 1);
  surface.name = name;
  surface.structural = true;
  surfaces_.push_back(std::move(surface));
  return surfaces_.back().label;
}

void Scene::add_part(const Part& part, const Isometry3d& pose, const std::string& owner) {
  Solid solid = part.solid;
  solid.pose = pose * part.solid.pose;
  add_solid(solid);
  Surface surface;
  surface.material = part.material;
  surface.label = static_cast<std::uint32_t>(objects_.size());
  surface.solid = static_cast<std::uint32_t>(solids_.size() - 1);
  const std::string name = part.name.empty() ? owner : owner + " " + part.name;
  if (solid.shape == SolidShape::Box) {
    add_box_faces(solid, surface, name);
  } else {
    add_round_faces(solid, surface, name);
  }
}

void Scene::add_box_faces(const Solid& solid, Surface surface, const std::string& name) {
  for (const BoxFace& face : kBoxFaces) {
    surface.geometry = box_face(solid, face);
    surface.name = name + " " + face.name;
    surfaces_.push_back(surface);
  }
}

void Scene::add_round_faces(const Solid& solid, Surface surface, const std::string& name) {
  const bool sphere = solid.shape == SolidShape::Sphere;
  surface.geometry = {sphere ? SurfaceShape::Sphere : SurfaceShape::CylinderSide, solid.pose,
                      solid.half.x(), solid.half.z()};
  surface.name = name + " side";
  surfaces_.push_back(surface);
  if (sphere) return;
  for (const BoxFace& face : {kBoxFaces[0], kBoxFaces[1]}) {
    surface.geometry = box_face(solid, face);
    surface.geometry.shape = SurfaceShape::Disc;
    surface.name = name + " " + face.name;
    surfaces_.push_back(surface);
  }
}

std::vector<std::vector<std::uint32_t>> Scene::find_occluders() const {
  std::vector<std::vector<std::uint32_t>> occluders(surfaces_.size());
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    const Box3d bounds = surfaces_[s].geometry.bounds();
    for (std::uint32_t k = 0; k < reach_.size(); ++k) {
      if (k != surfaces_[s].solid && bounds.intersects(reach_[k])) occluders[s].push_back(k);
    }
  }
  return occluders;
}

bool Scene::hidden(const SurfacePoint& point, const std::vector<std::uint32_t>& occluders) const {
  const Vector3d ahead = point.position + kHiddenGap * point.normal;
  return std::any_of(occluders.begin(), occluders.end(), [&](std::uint32_t k) {
    return within(reach_[k], point.position) && solids_[k].blocks(point.position, ahead);
  });
}

VisiblePart Scene::visible_part(const Surface& surface,
                                const std::vector<std::uint32_t>& occluders) const {
  constexpr double kCell = 0.01;  // [m]; fine enough for the legs of a chair
  const SurfaceGeometry& geometry = surface.geometry;
  const bool square_map = geometry.shape == SurfaceShape::Rectangle;
  const double round = 2 * std::numbers::pi * geometry.a;
  const double width = square_map ? 2 * geometry.a : round;
  const double height = geometry.shape == SurfaceShape::Disc ? geometry.a : 2 * geometry.b;
  const int columns = std::clamp(static_cast<int>(width / kCell), 16, 256);
  const int rows = std::clamp(static_cast<int>(height / kCell), 16, 256);
  VisiblePart part;
  if (occluders.empty()) return {geometry.area(), geometry.pose.translation()};
  std::size_t free = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const SurfacePoint point = geometry.sample((column + 0.5) / columns, (row + 0.5) / rows);
      if (hidden(point, occluders)) continue;
      ++free;
      part.centroid += point.position;
    }
  }
  part.area = geometry.area() * static_cast<double>(free) / (columns * rows);
  if (free > 0) part.centroid /= static_cast<double>(free);
  return part;
}

bool Scene::occupied(const Vector3d& p, double margin) const {
  return std::any_of(solids_.begin(), solids_.end(),
                     [&](const Solid& solid) { return solid.contains(p, margin); });
}

}  // namespace planescope::synthesis
