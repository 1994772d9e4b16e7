// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "planes/object_faces.hpp"
#include "planes_fixtures.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;
using V = Eigen::Vector3f;

// A floor that is a supporting plane; on it a box of 1 m, half a metre high, and a ramp of 30
// degrees; a step of the box's top that is too small for a face.
struct FurnishedFloor {
  PatchGraph graph;
  std::vector<SupportingPlane> supporting;
  std::vector<PatchPlane> patch_plane;
  PlaneOptions options;
  std::size_t floor_patches = 0;

  FurnishedFloor() {
    PatchGraphBuilder builder(0.1f, 0.002f, 0.03f, 7);
    builder.rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
    floor_patches = builder.patches().size();
    builder.rectangle(V(1, 1, 0.5f), V(1, 0, 0), V(0, 1, 0));              // the top
    builder.rectangle(V(1, 1, 0), V(1, 0, 0), V(0, 0, 0.5f));              // a side, along x
    builder.rectangle(V(3, 1, 0), V(0, 1, 0), V(-0.87f, 0, 0.5f));         // the ramp
    builder.rectangle(V(3.3f, 3.3f, 0.3f), V(0.3f, 0, 0), V(0, 0.3f, 0));  // a stool
    graph = builder.finish();
    graph.voxel_size = 0.02f;
    supporting.resize(1);
    patch_plane.resize(graph.patches.size());
    for (std::size_t i = 0; i < floor_patches; ++i) patch_plane[i].plane = 0;
    options.sigma = 0.02;
    options.face_area = 0.3;
  }

  ObjectFaces find() const {
    return place_object_faces(
        graph, patch_plane, select_object_faces(graph, supporting, patch_plane, options), options);
  }
};

TEST(ObjectFaces, AreTheLargeSidesInTheDirectionsOfTheRoom) {
  const FurnishedFloor scene;
  const ObjectFaces faces = scene.find();
  ASSERT_EQ(faces.planes.size(), 2u);  // neither the ramp, at 30 degrees, nor the stool, 0.09 m^2
  const Plane &top = faces.planes[0].plane, &side = faces.planes[1].plane;
  EXPECT_NEAR(faces.planes[0].area, 1.0, 0.1);
  EXPECT_NEAR(std::abs(top.normal.z()), 1, 1e-4);
  EXPECT_NEAR(top.signed_distance(V(1.5f, 1.5f, 0.5f)), 0, 0.002);
  EXPECT_NEAR(faces.planes[1].area, 0.5, 0.1);
  EXPECT_NEAR(std::abs(side.normal.y()), 1, 1e-3);
  for (const SupportingPlane& face : faces.planes) EXPECT_EQ(face.role, PlaneRole::Face);
}

TEST(ObjectFaces, TakeOnlyPatchesThatNoPlaneTook) {
  const FurnishedFloor scene;
  const ObjectFaces faces = scene.find();
  ASSERT_EQ(faces.patch_face.size(), scene.graph.patches.size());
  std::size_t on_top = 0;
  for (std::size_t i = 0; i < faces.patch_face.size(); ++i) {
    if (i < scene.floor_patches) {
      EXPECT_EQ(faces.patch_face[i], kNone);
    }
    on_top += faces.patch_face[i] == 0 ? 1 : 0;
  }
  EXPECT_NEAR(double(on_top), 100, 5);
}

TEST(ObjectFaces, SlantedOnesCountWhereAnglesDoNot) {
  FurnishedFloor scene;
  scene.options.weight_angle = 0;
  const ObjectFaces faces = scene.find();
  ASSERT_EQ(faces.planes.size(), 3u);
  const V ramp = V(0, 1, 0).cross(V(-0.87f, 0, 0.5f)).normalized();
  double best = 0;
  for (const SupportingPlane& face : faces.planes)
    best = std::max(best, double(std::abs(face.plane.normal.dot(ramp))));
  EXPECT_GT(best, std::cos(0.0175));  // a degree: it is not bent into the room's directions
}

TEST(ObjectFaces, ZeroAreaSwitchesThemOff) {
  FurnishedFloor scene;
  scene.options.face_area = 0;
  EXPECT_TRUE(scene.find().planes.empty());
  EXPECT_EQ(scene.find().patch_face, std::vector<std::int32_t>(scene.graph.patches.size(), kNone));
}

// Two seats a metre apart, one 6 mm higher: within sigma of one slanted plane, and level each.
TEST(ObjectFaces, AreFittedPieceByPiece) {
  FurnishedFloor scene;
  PatchGraphBuilder builder(0.1f, 0.0005f, 0.03f, 9);
  builder.rectangle(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
  builder.rectangle(V(0.5f, 1, 0.5f), V(0.8f, 0, 0), V(0, 0.8f, 0));
  builder.rectangle(V(2.3f, 1, 0.506f), V(0.8f, 0, 0), V(0, 0.8f, 0));
  scene.graph = builder.finish();
  scene.graph.voxel_size = 0.02f;
  scene.patch_plane.resize(scene.graph.patches.size());
  const ObjectFaces faces = scene.find();
  ASSERT_EQ(faces.planes.size(), 2u);
  double low = 1, high = 0;
  for (const SupportingPlane& face : faces.planes) {
    EXPECT_GT(std::abs(face.plane.normal.z()), std::cos(0.1 * 0.01745));  // as one: 0.19 degrees
    const double height =
        double(face.plane.distance -
               face.plane.normal.x() * (face.plane.distance > 0.503f ? 2.7f : 0.9f)) /
        double(face.plane.normal.z());
    low = std::min(low, height), high = std::max(high, height);
  }
  EXPECT_NEAR(low, 0.5, 0.002);
  EXPECT_NEAR(high, 0.506, 0.002);
}

TEST(ObjectFaces, GiveTheirPatchesTheirNormal) {
  FurnishedFloor scene;
  const ObjectFaces faces = scene.find();
  const std::vector<Patch> before = scene.graph.patches;
  steady_normals(scene.graph.patches, faces.planes, faces.patch_face);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const V& now = scene.graph.patches[i].normal;
    if (faces.patch_face[i] == kNone) {
      EXPECT_EQ(now, before[i].normal);
    } else {
      const auto f = static_cast<std::size_t>(faces.patch_face[i]);
      EXPECT_EQ(std::abs(now.dot(faces.planes[f].plane.normal)), now.squaredNorm());
      EXPECT_GT(now.dot(before[i].normal), 0);  // the side stays
    }
  }
}

}  // namespace
}  // namespace planescope
