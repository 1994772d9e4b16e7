// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "planescope/error.hpp"
#include "planescope/result.hpp"

/// \file A small scene, made by hand, and what is said of a folder that is refused.
namespace planescope::testing {

/// Six points: three on a floor patch, two on a box patch, one without a return.
inline PointCloud small_cloud() {
  constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
  PointCloud cloud;
  cloud.positions = {{0, 0, 0},           {1, 0, 0},           {0, 1, 0},
                     {0.5f, 0.5f, 0.25f}, {0.1f, 0.5f, 0.25f}, {kNoReturn, kNoReturn, kNoReturn}};
  cloud.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}, {253, 254, 255}, {0, 0, 0}};
  cloud.labels = {1, 1, 1, 2, 2, 0};
  cloud.width = 3;
  cloud.height = 2;
  cloud.sensor = Eigen::Vector3f(0, 0, 2);
  return cloud;
}

/// What segment() could have made of it, by hand.
inline Segmentation small_scene() {
  Segmentation scene;
  scene.options = Options::tabletop();
  scene.graph.patches.resize(2);
  scene.graph.point_patch = {0, 0, 0, 1, 1, kNone};
  SupportingPlane floor;
  floor.patch_count = 1;
  floor.point_count = 3;
  floor.area = 0.1f;
  scene.planes = {floor};
  scene.patch_plane = {{0, 1.0f}, {kNone, 1.0f}};
  scene.selection.lambda = 2;
  scene.selection.proposed = 9;
  scene.selection.hypotheses.resize(3);
  for (PlaneHypothesis& h : scene.selection.hypotheses) h.inlier_count = 3;
  scene.selection.hypotheses[0].selected = true;
  scene.selection.hypotheses[1].blocked_by = 0;
  scene.selection.hypotheses[1].blocked_angle_cost = 0.75;
  scene.selection.hypotheses[2].inlier_count = 2;  // not more than lambda: not reported
  scene.selection.selected = {0};
  Edge edge;
  edge.second = 1;
  edge.rule = EdgeRule::PlaneBoundary;
  scene.edges = {edge};
  scene.segments.segments = {{1, 0, 1, 3, 0.1f, {0.5f, 0.5f, 0}},
                             {2, kNone, 1, 2, 0.05f, {0.3f, 0.5f, 0.25f}}};
  scene.segments.patch_label = {1, 2};
  scene.point_label = {1, 1, 1, 2, 2, kNoSegment};
  scene.point_plane = {0, 0, 0, kNone, kNone, kNone};
  return scene;
}

/// The message with which the folder is refused.
inline std::string refusal(const std::filesystem::path& folder) {
  try {
    load_result(folder);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    return error.what();
  }
  return {};
}

}  // namespace planescope::testing
