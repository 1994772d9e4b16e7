// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "synthesize/camera.hpp"
#include "synthesize/geometry.hpp"
#include "synthesize/raycaster.hpp"
#include "synthesize/room.hpp"
#include "synthesize/views.hpp"

namespace planescope::synthesis {
namespace {

class Dice {
 public:
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3d vector(double reach) {
    const double x = (*this)(-reach, reach), y = (*this)(-reach, reach);
    return {x, y, (*this)(-reach, reach)};
  }
  Isometry3d pose(double reach) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = vector(reach);
    pose.rotate(Eigen::AngleAxisd((*this)(0, 6), vector(1).normalized()));
    return pose;
  }
  Solid solid(SolidShape shape) {
    const double a = (*this)(0.2, 0.6), b = (*this)(0.2, 0.6), c = (*this)(0.2, 0.6);
    const Vector3d half = shape == SolidShape::Box      ? Vector3d(a, b, c)
                          : shape == SolidShape::Sphere ? Vector3d(a, a, a)
                                                        : Vector3d(a, a, c);
    return {shape, pose(0.5), half};
  }

 private:
  std::mt19937_64 engine_{11};
};

TEST(SynthesisGeometry, BlockingAgreesWithWalkingAlongTheSegment) {
  Dice dice;
  int blocked = 0, cases = 0;
  for (const SolidShape shape : {SolidShape::Box, SolidShape::Sphere, SolidShape::Cylinder}) {
    for (int i = 0; i < 400; ++i, ++cases) {
      const Solid solid = dice.solid(shape);
      const Vector3d p = dice.vector(1), q = dice.vector(1);
      const auto walk = [&](double margin) {
        bool inside = false;
        for (int k = 0; k <= 1000; ++k) inside |= solid.contains(p + (q - p) * k / 1000, margin);
        return inside;
      };
      if (walk(-0.004)) {
        EXPECT_TRUE(solid.blocks(p, q));
      } else if (!walk(0.004)) {
        EXPECT_FALSE(solid.blocks(p, q));
      }
      blocked += solid.blocks(p, q) ? 1 : 0;
    }
  }
  EXPECT_GT(blocked, cases / 5);
  EXPECT_LT(blocked, cases * 4 / 5);
}

TEST(SynthesisGeometry, TouchingIsNotBlockingFromOutsideButIsThroughAContact) {
  Solid box;
  box.half = Vector3d(1, 1, 1);
  EXPECT_FALSE(box.blocks({0, 0, 1}, {0, 0, 1.1}));  // away from its top
  EXPECT_TRUE(box.blocks({0, 0, 1}, {0, 0, 0.9}));   // into it
  EXPECT_FALSE(box.blocks({-2, 0, 1}, {2, 0, 1}));   // along its top
  EXPECT_TRUE(box.blocks({-2, 0, 0.9}, {2, 0, 0.9}));
}

TEST(SynthesisGeometry, CollisionAgreesWithPointsOfBothBoxes) {
  Dice dice;
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    Solid a = dice.solid(SolidShape::Box), b = dice.solid(SolidShape::Box);
    b.pose.translation() *= 2;
    bool shared = false;
    for (int k = 0; k < 3000 && !shared; ++k) {
      shared = b.contains(a.pose * dice.vector(1).cwiseProduct(a.half), -1e-9);
    }
    if (shared) {
      EXPECT_TRUE(boxes_collide(a, b, 0));
    }
    if (!boxes_collide(a, b, 0)) {
      EXPECT_FALSE(shared);
    }
    hits += shared ? 1 : 0;
  }
  EXPECT_GT(hits, 60);
  EXPECT_LT(hits, 280);
  Solid left, right;  // two unit boxes, 10 cm apart
  left.half = right.half = Vector3d::Constant(0.5);
  right.pose.translation().x() = 1.1;
  EXPECT_FALSE(boxes_collide(left, right, 0.09));
  EXPECT_TRUE(boxes_collide(left, right, 0.11));
}

TEST(SynthesisGeometry, SamplesLieOnTheSurfaceAndFaceOutwards) {
  Dice dice;
  for (const SurfaceShape shape : {SurfaceShape::Rectangle, SurfaceShape::Disc,
                                   SurfaceShape::Sphere, SurfaceShape::CylinderSide}) {
    const SurfaceGeometry surface{shape, dice.pose(1), 0.7, 0.3};
    for (int i = 0; i < 200; ++i) {
      const SurfacePoint point = surface.sample(dice(0, 1), dice(0, 1));
      const Vector3d local = surface.pose.inverse() * point.position;
      const double flat = local.head<2>().norm();
      if (shape == SurfaceShape::Rectangle) {
        EXPECT_TRUE(std::abs(local.x()) <= 0.7 && std::abs(local.y()) <= 0.3);
      }
      if (shape == SurfaceShape::Disc) {
        EXPECT_LE(flat, 0.7 + 1e-9);
      }
      if (surface.planar()) {
        EXPECT_NEAR(local.z(), 0, 1e-12);
      }
      if (shape == SurfaceShape::Sphere) {
        EXPECT_NEAR(local.norm(), 0.7, 1e-9);
      }
      if (shape == SurfaceShape::CylinderSide) {
        EXPECT_NEAR(flat, 0.7, 1e-9);
      }
      EXPECT_NEAR(point.normal.norm(), 1, 1e-9);
      // A ray against the normal meets this very point.
      const Ray ray{point.position + 0.2 * point.normal, -point.normal};
      const bool at_rim = shape == SurfaceShape::CylinderSide && std::abs(local.z()) > 0.299;
      if (!at_rim) {
        EXPECT_NEAR(surface.intersect(ray), 0.2, 1e-6);
      }
      EXPECT_LT((surface.at(point.position).normal - point.normal).norm(), 1e-6);
    }
  }
}

TEST(SynthesisGeometry, EqualAreasGetEqualShares) {
  // A sphere's points: a quarter of them lie in each quarter of its height; a disc's: a quarter
  // within half its radius.
  const SurfaceGeometry sphere{SurfaceShape::Sphere, Isometry3d::Identity(), 2, 2};
  const SurfaceGeometry disc{SurfaceShape::Disc, Isometry3d::Identity(), 2, 2};
  constexpr int kSide = 100;
  int cap = 0, core = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double u = (i % kSide + 0.5) / kSide, v = (i / kSide + 0.5) / kSide;
    cap += sphere.sample(u, v).position.z() > 1 ? 1 : 0;
    core += disc.sample(u, v).position.norm() < 1 ? 1 : 0;
  }
  EXPECT_EQ(cap, kSide * kSide / 4);
  EXPECT_EQ(core, kSide * kSide / 4);
  EXPECT_NEAR(sphere.area(), 16 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(disc.area(), 4 * std::numbers::pi, 1e-12);
}

TEST(RayCaster, AgreesWithTryingEverySurface) {
  Dice dice;
  const Room room = make_room(2, true);
  const RayCaster caster(room.scene);
  for (int i = 0; i < 3000; ++i) {
    Ray ray{dice.vector(1.5) + Vector3d(0, 0, 1.5), dice.vector(1)};
    if (i % 10 == 0) ray.direction = Vector3d::Unit(i / 10 % 3);  // zeros in the direction
    Hit expected;
    for (std::size_t s = 0; s < room.scene.surfaces().size(); ++s) {
      const double t = room.scene.surfaces()[s].geometry.intersect(ray);
      if (t < expected.t) expected = {t, static_cast<std::int32_t>(s)};
    }
    const Hit hit = caster.cast(ray);
    EXPECT_EQ(hit.surface, expected.surface);
    EXPECT_EQ(hit.t, expected.t);
  }
}

TEST(Cameras, StandInFreeSpaceAndLookAtFurniture) {
  const Room room = make_room(4, true);
  const RayCaster caster(room.scene);
  for (const Camera& camera : place_cameras(room, caster, 4, 12)) {
    const Vector3d eye = camera.pose.translation();
    EXPECT_GE(eye.z(), 1.2);
    EXPECT_LE(eye.z(), 1.8);
    EXPECT_FALSE(room.scene.occupied(eye, 0.2));
    const Vector3d inside = room.frame.inverse() * eye;
    EXPECT_LT(std::abs(inside.x()), room.half.x());
    EXPECT_LT(std::abs(inside.y()), room.half.y());
    const Eigen::Matrix3d axes = camera.pose.linear();
    EXPECT_NEAR(axes.determinant(), 1, 1e-9);
    const double pitch = std::asin(-axes(2, 2)) * 180 / std::numbers::pi;
    EXPECT_GE(pitch, 10 - 1e-9);
    EXPECT_LE(pitch, 35 + 1e-9);
    EXPECT_LT(axes(2, 1), -0.7) << "y points down";
  }
}

// A camera 25 cm above a floor without end, looking along it.
struct FloorView {
  FloorView() {
    Solid slab;
    slab.half = Vector3d(20, 20, 0.1);
    slab.pose.translation() = Vector3d(0, 0, -0.1);
    scene.add_structure(slab, {}, "floor");
    camera.pose.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // right -y, down -z, forward x
    camera.pose.translation() = Vector3d(0, 0, 0.25);
    view = render_depth(RayCaster(scene), camera);
  }

  // Angle between the ray of a pixel and the floor's normal [deg].
  double angle(int column, int row) const {
    return std::acos(-camera.ray(column, row).direction.normalized().z()) * 180 / std::numbers::pi;
  }

  Scene scene;
  Camera camera;
  DepthView view;
};

TEST(Cameras, ReturnsAreLostAtGrazingAnglesAndOutOfRange) {
  const FloorView floor;
  SynthesisOptions options;
  options.noise = 0;
  const PointCloud cloud = sense(floor.scene, floor.camera, floor.view, options, 0);
  std::map<int, int> pixels, lost;  // by whole degrees
  for (int row = 0; row < 480; ++row) {
    for (int column = 0; column < 640; ++column) {
      const auto i = static_cast<std::size_t>(row * 640 + column);
      const double z = row < 240 ? 0 : 0.25 * 525 / (row - 239.5);  // of the floor, by hand
      ASSERT_EQ(floor.view.surface[i] == 0, row >= 240 && z < 20) << row;
      if (row >= 240 && z < 20) {
        ASSERT_NEAR(static_cast<double>(floor.view.depth[i]), z, 1e-5 * z);
      }
      if (z < 0.5 || z > 6) {
        ASSERT_FALSE(is_finite(cloud.positions[i])) << row << ' ' << z;
        continue;
      }
      const int degrees = static_cast<int>(floor.angle(column, row));
      ++pixels[degrees];
      lost[degrees] += is_finite(cloud.positions[i]) ? 0 : 1;
    }
  }
  const auto share = [&](int degrees) {
    EXPECT_GT(pixels[degrees], 1000) << degrees;
    return static_cast<double>(lost[degrees]) / pixels[degrees];
  };
  EXPECT_EQ(share(70), 0);
  EXPECT_EQ(share(74), 0);
  // 3 x^2 - 2 x^3 at x = (angle - 75) / 15, in the middle of each degree.
  EXPECT_NEAR(share(78), 0.1381, 0.02);
  EXPECT_NEAR(share(82), 0.5, 0.03);
  EXPECT_NEAR(share(86), 0.8619, 0.03);
}

}  // namespace
}  // namespace planescope::synthesis
