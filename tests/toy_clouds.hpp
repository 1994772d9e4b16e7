// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <random>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

/// \file Small clouds built by hand for the tests of several stages.
namespace planescope::testing {

/// Portable uniform numbers in [0, 1): std's distributions may differ from one library to another.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  float operator()() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }

 private:
  std::mt19937_64 engine_;
};

/// Appends `count` random points of the parallelogram corner + [0,1) u + [0,1) v, with a label.
inline void add_rectangle(PointCloud& cloud, Uniform& uniform, int count,
                          const Eigen::Vector3f& corner, const Eigen::Vector3f& u,
                          const Eigen::Vector3f& v, std::uint32_t label = 0) {
  for (int i = 0; i < count; ++i) {
    const float a = uniform(), b = uniform();
    cloud.positions.push_back(corner + a * u + b * v);
    cloud.labels.push_back(label);
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  cloud.height = 1;
}

/// An empty room of 3 x 2 x 2 m without a ceiling: labels 1 floor, 2 to 5 walls.
inline PointCloud make_box_room(int points_per_square_metre, std::uint64_t seed = 1) {
  PointCloud cloud;
  Uniform uniform(seed);
  const Eigen::Vector3f x(3, 0, 0), y(0, 2, 0), z(0, 0, 2), o(0, 0, 0);
  add_rectangle(cloud, uniform, 6 * points_per_square_metre, o, x, y, 1);
  add_rectangle(cloud, uniform, 6 * points_per_square_metre, o, x, z, 2);
  add_rectangle(cloud, uniform, 6 * points_per_square_metre, y, x, z, 3);
  add_rectangle(cloud, uniform, 4 * points_per_square_metre, o, y, z, 4);
  add_rectangle(cloud, uniform, 4 * points_per_square_metre, x, y, z, 5);
  return cloud;
}

}  // namespace planescope::testing
