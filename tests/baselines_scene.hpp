// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "planescope/cloud.hpp"
#include "planescope/error.hpp"

/// \file The scene by hand that the peers are tested on.
namespace planescope::testing {

inline constexpr float kStep = 0.004F;  // [m] spacing of the toy scene's points

/// A rectangle from `corner` along two axes, points at kStep, labelled.
inline void add_face(PointCloud& cloud, const Eigen::Vector3f& corner, const Eigen::Vector3f& along,
                     const Eigen::Vector3f& across, std::uint32_t label) {
  const int columns = static_cast<int>(std::lround(along.norm() / kStep));
  const int rows = static_cast<int>(std::lround(across.norm() / kStep));
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) {
      const float u = static_cast<float>(c) / static_cast<float>(columns);
      const float v = static_cast<float>(r) / static_cast<float>(rows);
      // A little off the lattice, in the plane: no point lies on a voxel's border exactly.
      const float off = 0.05F * kStep * std::sin(static_cast<float>(cloud.size()));
      cloud.positions.push_back(corner + u * along + v * across +
                                off * (along.normalized() + across.normalized()));
      cloud.labels.push_back(label);
      cloud.colors.push_back({200, 150, 100});
    }
}

/// The three faces of a cube that a sensor sees from above, from smaller y, and from the side that
/// `right` tells.
inline void add_box(PointCloud& cloud, const Eigen::Vector3f& corner, float size, bool right,
                    std::uint32_t label) {
  const Eigen::Vector3f x = size * Eigen::Vector3f::UnitX(), y = size * Eigen::Vector3f::UnitY(),
                        z = size * Eigen::Vector3f::UnitZ();
  add_face(cloud, corner + z, x, y, label);
  add_face(cloud, corner, x, z, label);
  add_face(cloud, right ? Eigen::Vector3f(corner + x) : corner, y, z, label);
}

/// Two boxes of 12 cm on a table of 0.8 m x 0.6 m (label 1), seen from above; every 7th slot is a
/// point without return.
inline PointCloud toy_scene() {
  PointCloud full;
  add_face(full, {0, 0, 0}, {0.8F, 0, 0}, {0, 0.6F, 0}, 1);
  add_box(full, {0.15F, 0.2F, 0.002F}, 0.12F, true, 2);
  add_box(full, {0.5F, 0.25F, 0.002F}, 0.12F, false, 3);
  PointCloud cloud;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < full.size(); ++i) {
    const bool inside = full.labels[i] == 1 && [](const Eigen::Vector3f& p) {
      const auto in = [&](float x, float y) {
        return p.x() > x && p.x() < x + 0.12F && p.y() > y && p.y() < y + 0.12F;
      };
      return in(0.15F, 0.2F) || in(0.5F, 0.25F);
    }(full.positions[i]);
    if (inside) continue;
    cloud.positions.push_back(full.positions[i]);
    cloud.labels.push_back(full.labels[i]);
    cloud.colors.push_back(full.colors[i]);
    if (i % 7 == 0) {
      cloud.positions.push_back(Eigen::Vector3f::Constant(nan));
      cloud.labels.push_back(0);
      cloud.colors.push_back({});
    }
  }
  if (cloud.size() % 2 != 0) {
    cloud.positions.push_back(Eigen::Vector3f::Constant(nan));
    cloud.labels.push_back(0);
    cloud.colors.push_back({});
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  cloud.sensor = Eigen::Vector3f(0.4F, -0.6F, 1.0F);
  return cloud;
}

/// The kind of error that a call throws; the message is one line.
inline Error::Kind kind_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return Error::Kind::Internal;
}

}  // namespace planescope::testing
