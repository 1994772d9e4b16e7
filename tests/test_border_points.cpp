// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "border_points.hpp"

namespace planescope {
namespace {

using V = Eigen::Vector3f;

// Two patches: a floor about the origin, on supporting plane 0, and a wall that stands on it at
// x = 0.1, on none. All points start on the floor's patch but for the last, on the wall's.
struct TwoPatches {
  Segmentation scene;
  PointCloud cloud;

  explicit TwoPatches(const std::vector<V>& points) {
    scene.graph.patches.resize(2);
    scene.graph.patches[0].area = scene.graph.patches[1].area = 0.0314f;  // radius 0.1 m
    scene.graph.patches[1].normal = V(-1, 0, 0);
    scene.graph.patches[1].centroid = V(0.1f, 0, 0.1f);
    scene.graph.adjacency = {{0, 1, 3}};
    scene.planes.resize(1);
    scene.patch_plane = {{0, 1}, {kNone, 1}};
    scene.patch_face = {kNone, kNone};
    scene.segments.segments.resize(2);
    scene.segments.patch_label = {1, 2};
    cloud.positions = points;
    scene.graph.point_patch.assign(points.size(), 0);
    scene.graph.point_patch.back() = 1;
    scene.graph.patches[0].point_count = static_cast<std::uint32_t>(points.size() - 1);
    scene.graph.patches[1].point_count = 1;
  }

  std::vector<std::int32_t> recut() const { return recut_borders(scene, cloud).patch; }
};

TEST(BorderPoints, GoToTheSurfaceThatTheyLieNearerTo) {
  // By hand, 0.7 for the plane, 0.95 for the patch that has the point:
  // (0.09, 0, 0.05): floor 0.95 * 0.7 * 0.05 = 0.033, wall 0.01: moves.
  // (0.05, 0, 0.001): floor 0.0007, wall 0.05: stays.
  // (0.09, 0, 0.014): floor 0.0093, wall 0.01: stays.
  // (0.02, 0, 0): the wall's own, at 0.95 * 0.08; the floor has 0: moves.
  TwoPatches two({V(0.09f, 0, 0.05f), V(0.05f, 0, 0.001f), V(0.09f, 0, 0.014f), V(0.02f, 0, 0)});
  EXPECT_EQ(two.recut(), (std::vector<std::int32_t>{1, 0, 0, 0}));
}

TEST(BorderPoints, LeaveAPlaneOnlyBeyondItsNoise) {
  // (0.09, 0, 0.05) as above: floor 0.033, wall 0.01. With an rms of 22 mm it goes, of 25 mm it
  // stays; the wall's point, on no plane, goes to the floor whatever the floor's noise.
  TwoPatches two({V(0.09f, 0, 0.05f), V(0.02f, 0, 0)});
  two.scene.planes[0].rms = 0.022f;
  EXPECT_EQ(two.recut(), (std::vector<std::int32_t>{1, 0}));
  two.scene.planes[0].rms = 0.025f;
  EXPECT_EQ(two.recut()[0], 0);
}

TEST(BorderPoints, WhatLiesBesideAPatchCountsATenth) {
  // (0.1, 0.5, 0.02): on the wall's plane but 0.41 m beside its rim: 0.041, the floor has
  // 0.95 * (0.014 + 0.041) = 0.052: moves; one at half the height stays.
  TwoPatches two({V(0.1f, 0.5f, 0.02f), V(0.1f, 0.5f, 0.002f), V(0.1f, 0, 0.1f)});
  const std::vector<std::int32_t> patch = two.recut();
  EXPECT_EQ(patch[0], 1);
  EXPECT_EQ(patch[2], 1);
}

TEST(BorderPoints, WithinASegmentNothingMoves) {
  TwoPatches two({V(0.09f, 0, 0.05f), V(0.02f, 0, 0)});
  two.scene.segments.patch_label = {1, 1};
  EXPECT_EQ(two.recut(), (std::vector<std::int32_t>{0, 1}));
}

TEST(BorderPoints, ASegmentKeepsItsLastPoints) {
  // Alone, the wall's only point lies on the floor: it would leave a segment without points.
  TwoPatches two({V(0.05f, 0, 0.001f), V(0.02f, 0, 0)});
  EXPECT_EQ(two.recut(), (std::vector<std::int32_t>{0, 1}));
}

}  // namespace
}  // namespace planescope
