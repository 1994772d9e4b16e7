// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "planes/random.hpp"
#include "planescope/patches.hpp"

/// \file Patch graphs for the tests of hypotheses, selection and assignment.
namespace planescope::testing {

/// Builds graphs of square patches on rectangles and spheres.
class PatchGraphBuilder {
 public:
  PatchGraphBuilder(float spacing, float noise, float normal_noise, std::uint64_t seed)
      : spacing_(spacing), noise_(noise), normal_noise_(normal_noise), random_(seed) {}

  void patch(const Eigen::Vector3f& centroid, const Eigen::Vector3f& normal) {
    Patch p;
    p.centroid = centroid + noise_ * gauss() * normal;
    p.normal = (normal + normal_noise_ * Eigen::Vector3f(gauss(), gauss(), gauss())).normalized();
    p.curvature = 0.01f;
    p.area = spacing_ * spacing_;
    p.point_count = p.voxel_count = 25;
    graph_.patches.push_back(p);
  }

  /// Patches at the centres of a grid over the rectangle from `corner` along u and v; normal u x v.
  void rectangle(const Eigen::Vector3f& corner, const Eigen::Vector3f& u,
                 const Eigen::Vector3f& v) {
    const auto columns = static_cast<int>(std::lround(u.norm() / spacing_));
    const auto rows = static_cast<int>(std::lround(v.norm() / spacing_));
    const Eigen::Vector3f normal = u.cross(v).normalized();
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        const float a = (static_cast<float>(i) + 0.5f) / static_cast<float>(columns);
        const float b = (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
        patch(corner + a * u + b * v, normal);
      }
    }
  }

  void sphere(const Eigen::Vector3f& center, float radius, int patches) {
    for (int i = 0; i < patches; ++i) {
      const Eigen::Vector3f out = Eigen::Vector3f(gauss(), gauss(), gauss()).normalized();
      patch(center + radius * out, out);
    }
  }

  /// The patches alone, for graphs too large for finish().
  std::vector<Patch> patches() const { return graph_.patches; }

  /// Joins patches that lie within 1.6 spacings of each other.
  PatchGraph finish() {
    for (std::uint32_t i = 0; i < graph_.patches.size(); ++i) {
      for (std::uint32_t j = i + 1; j < graph_.patches.size(); ++j) {
        const float gap = (graph_.patches[i].centroid - graph_.patches[j].centroid).norm();
        if (gap < 1.6f * spacing_) graph_.adjacency.push_back({i, j, 3});
      }
    }
    graph_.patch_size = spacing_;
    return graph_;
  }

 private:
  float gauss() {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += uniform_unit(random_);
    return static_cast<float>(sum);
  }

  float spacing_, noise_, normal_noise_;
  std::mt19937_64 random_;
  PatchGraph graph_;
};

/// A room of 4 x 4 x 2.4 m: floor, four walls, a table top at 0.75 m, a cupboard's side at x = 3.4
/// m; and what should not be selected: a ramp at 30 degrees, a board turned by 40 degrees, a ball.
inline PatchGraph toy_room(std::uint64_t seed = 1, float noise = 0.003f) {
  using V = Eigen::Vector3f;
  PatchGraphBuilder room(0.2f, noise, 0.03f, seed);
  room.rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
  room.rectangle(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2.4f));
  room.rectangle(V(4, 0, 0), V(0, 0, 2.4f), V(0, 4, 0));
  room.rectangle(V(0, 0, 0), V(0, 0, 2.4f), V(4, 0, 0));
  room.rectangle(V(0, 4, 0), V(4, 0, 0), V(0, 0, 2.4f));
  room.rectangle(V(1, 1, 0.75f), V(1.4f, 0, 0), V(0, 1.2f, 0));
  room.rectangle(V(3.4f, 1.2f, 0.2f), V(0, 0, 1.8f), V(0, 1.2f, 0));
  room.rectangle(V(0.4f, 2.6f, 0.2f), V(1, 0, 0), V(0, 0.87f, 0.5f));
  room.rectangle(V(2.2f, 2.8f, 1.2f), V(0.77f, 0.64f, 0), V(0, 0, 0.8f));
  room.sphere(V(2.8f, 0.7f, 0.4f), 0.3f, 30);
  return room.finish();
}

/// The seven planes of the toy room as (normal, distance).
inline std::vector<Eigen::Vector4f> toy_planes() {
  return {{0, 0, 1, 0},   {1, 0, 0, 0},     {-1, 0, 0, -4},   {0, 1, 0, 0},
          {0, -1, 0, -4}, {0, 0, 1, 0.75f}, {-1, 0, 0, -3.4f}};
}

}  // namespace planescope::testing
