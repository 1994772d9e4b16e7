// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/pipeline.hpp"

/// \file A small room for the render tests, built directly as the engine's output, so that a
/// picture changes only when the drawing does.
namespace planescope::testing {

/// A rectangle: corner + s * u + t * v, s and t in [0, 1]; it is seen from the side of u x v.
struct Face {
  Eigen::Vector3f corner, u, v;
  Rgb color;
  std::uint32_t label;         ///< segment, from 1
  std::int32_t plane = kNone;  ///< supporting plane
};

/// A cloud and a segmentation of it.
struct ToyScene {
  PointCloud cloud;
  Segmentation scene;
};

/// Samples faces at `spacing` [m] with jitter and cuts them into patches of `patch` [m].
class ToySceneBuilder {
 public:
  ToySceneBuilder(float spacing, float patch, float noise = 0.002F)
      : spacing_(spacing), patch_(patch), noise_(noise) {
    toy_.scene.graph.voxel_size = patch / 5;
    toy_.scene.graph.patch_size = patch;
  }

  void add(const Face& face) {
    const int columns = std::max(1, static_cast<int>(std::lround(face.u.norm() / patch_)));
    const int rows = std::max(1, static_cast<int>(std::lround(face.v.norm() / patch_)));
    const Eigen::Vector3f normal = face.u.cross(face.v).normalized();
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        add_patch(face, normal, static_cast<float>(column) / static_cast<float>(columns),
                  static_cast<float>(row) / static_cast<float>(rows),
                  1 / static_cast<float>(columns), 1 / static_cast<float>(rows));
  }

  /// Five faces of a box that stands at `low`: no bottom.
  void add_box(const Eigen::Vector3f& low, const Eigen::Vector3f& size, Rgb color,
               std::uint32_t label, std::int32_t top_plane = kNone) {
    const Eigen::Vector3f x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    const auto shade = [&](int d) {
      return Rgb{static_cast<std::uint8_t>(std::max(0, color.r - d)),
                 static_cast<std::uint8_t>(std::max(0, color.g - d)),
                 static_cast<std::uint8_t>(std::max(0, color.b - d))};
    };
    add({low + z, x, y, color, label, top_plane});
    add({low, x, z, shade(25), label});
    add({low + y, z, x, shade(25), label});
    add({low, z, y, shade(40), label});
    add({low + x, y, z, shade(40), label});
  }

  ToyScene finish() {
    toy_.cloud.width = static_cast<std::uint32_t>(toy_.cloud.size());
    connect();
    count();
    return std::move(toy_);
  }

 private:
  float uniform() { return static_cast<float>(random_() >> 40) / static_cast<float>(1 << 24); }

  void add_patch(const Face& face, const Eigen::Vector3f& normal, float s, float t, float ds,
                 float dt) {
    Segmentation& scene = toy_.scene;
    const auto id = static_cast<std::int32_t>(scene.graph.patches.size());
    Patch patch;
    patch.normal = normal;
    patch.centroid = face.corner + (s + ds / 2) * face.u + (t + dt / 2) * face.v;
    patch.area = (ds * face.u).cross(dt * face.v).norm();
    patch.color = Eigen::Vector3f(face.color.r, face.color.g, face.color.b);
    const int across = std::max(1, static_cast<int>(std::lround(ds * face.u.norm() / spacing_)));
    const int along = std::max(1, static_cast<int>(std::lround(dt * face.v.norm() / spacing_)));
    patch.point_count = static_cast<std::uint32_t>(across * along);
    patch.voxel_count = 25;
    for (int i = 0; i < across * along; ++i) {
      const float a = (static_cast<float>(i % across) + uniform()) / static_cast<float>(across);
      const float b = (static_cast<float>(i / across) + uniform()) / static_cast<float>(along);
      toy_.cloud.positions.push_back(face.corner + (s + a * ds) * face.u + (t + b * dt) * face.v +
                                     noise_ * (2 * uniform() - 1) * normal);
      toy_.cloud.colors.push_back(face.color);
      scene.graph.point_patch.push_back(id);
      scene.point_label.push_back(face.label);
      scene.point_plane.push_back(face.plane);
    }
    scene.graph.patches.push_back(patch);
    scene.patch_plane.push_back({face.plane, 0.5F});
    scene.segments.patch_label.push_back(face.label);
  }

  /// Joins patches whose centroids are near, found on a grid of cells.
  void connect() {
    const auto& patches = toy_.scene.graph.patches;
    const float reach = 1.3F * patch_;
    const auto cell = [&](const Eigen::Vector3f& p) {
      return std::tuple(std::floor(p.x() / reach), std::floor(p.y() / reach),
                        std::floor(p.z() / reach));
    };
    std::map<std::tuple<float, float, float>, std::vector<std::uint32_t>> cells;
    for (std::uint32_t i = 0; i < patches.size(); ++i)
      cells[cell(patches[i].centroid)].push_back(i);
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
      std::vector<std::uint32_t> near;
      const auto [x, y, z] = cell(patches[i].centroid);
      for (int n = 0; n < 27; ++n) {
        const auto found =
            cells.find({x + static_cast<float>(n % 3 - 1), y + static_cast<float>(n / 3 % 3 - 1),
                        z + static_cast<float>(n / 9 - 1)});
        if (found == cells.end()) continue;
        for (const std::uint32_t j : found->second)
          if (j > i && (patches[i].centroid - patches[j].centroid).norm() < reach)
            near.push_back(j);
      }
      std::sort(near.begin(), near.end());
      for (const std::uint32_t j : near) add_edge(i, j);
    }
  }

  void add_edge(std::uint32_t i, std::uint32_t j) {
    Segmentation& scene = toy_.scene;
    const std::int32_t a = scene.patch_plane[i].plane, b = scene.patch_plane[j].plane;
    const bool same = scene.segments.patch_label[i] == scene.segments.patch_label[j];
    Edge edge;
    edge.first = i;
    edge.second = j;
    edge.border = 5;
    edge.rule =
        a != b ? (a == kNone || b == kNone ? EdgeRule::PlaneBoundary : EdgeRule::DifferentPlanes)
               : (a != kNone ? EdgeRule::SamePlane : (same ? EdgeRule::Convex : EdgeRule::Concave));
    edge.on = edge.rule == EdgeRule::SamePlane || edge.rule == EdgeRule::Convex;
    edge.margin = 0.5F;
    scene.graph.adjacency.push_back({i, j, 5});
    scene.edges.push_back(edge);
  }

  void count() {
    Segmentation& scene = toy_.scene;
    for (std::size_t i = 0; i < scene.graph.patches.size(); ++i) {
      const Patch& patch = scene.graph.patches[i];
      const std::uint32_t label = scene.segments.patch_label[i];
      auto& segments = scene.segments.segments;
      while (segments.size() < label)
        segments.push_back({static_cast<std::uint32_t>(segments.size()) + 1});
      Segment& segment = segments[label - 1];
      ++segment.patch_count;
      segment.point_count += patch.point_count;
      segment.area += patch.area;
      const std::int32_t index = scene.patch_plane[i].plane;
      if (index == kNone) continue;
      segment.plane = index;
      while (scene.planes.size() <= static_cast<std::size_t>(index)) scene.planes.emplace_back();
      SupportingPlane& plane = scene.planes[static_cast<std::size_t>(index)];
      plane.plane = {patch.normal, patch.normal.dot(patch.centroid)};
      ++plane.patch_count;
      plane.point_count += patch.point_count;
      plane.area += patch.area;
      plane.rms = noise_;
    }
  }

  std::mt19937_64 random_{7};
  float spacing_, patch_, noise_;
  ToyScene toy_;
};

/// A room of 4 x 3 x 2.4 m, z up, floor at z = 0: four walls, a table, a cupboard, two boxes on the
/// floor and one on the table; 10 segments, 6 planes.
inline ToyScene toy_room(float spacing = 0.02F, float patch = 0.12F) {
  ToySceneBuilder room(spacing, patch);
  const Eigen::Vector3f o(0, 0, 0), x(4, 0, 0), y(0, 3, 0), z(0, 0, 2.4F);
  room.add({o, x, y, {172, 140, 110}, 1, 0});
  room.add({y, z, -y, {214, 205, 190}, 2, 1});      // x = 0, seen from +x
  room.add({x, z, y, {205, 210, 205}, 3, 2});       // x = 4, seen from -x
  room.add({o, z, x, {200, 200, 212}, 4, 3});       // y = 0, seen from +y
  room.add({x + y, z, -x, {222, 214, 200}, 5, 4});  // y = 3, seen from -y
  room.add({{1.2F, 1.2F, 0.75F}, {1.4F, 0, 0}, {0, 0.8F, 0}, {120, 80, 50}, 6, 5});
  room.add_box({0.1F, 1.0F, 0}, {0.5F, 1.2F, 1.8F}, {90, 110, 140}, 7);
  room.add_box({2.9F, 0.5F, 0}, {0.5F, 0.5F, 0.5F}, {190, 70, 60}, 8);
  room.add_box({3.2F, 2.1F, 0}, {0.6F, 0.4F, 0.9F}, {80, 140, 80}, 9);
  room.add_box({1.6F, 1.4F, 0.75F}, {0.4F, 0.3F, 0.25F}, {225, 190, 60}, 10);
  return room.finish();
}

}  // namespace planescope::testing
