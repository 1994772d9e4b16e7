// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>

#include "camera.hpp"
#include "fit_points.hpp"
#include "scene_data.hpp"
#include "sensor_noise.hpp"
#include "shape_layers.hpp"
#include "test_render_scene.hpp"
#include "viewpoint.hpp"

/// \file Cameras and views: what is in the picture, upright, and what is left out of it.
namespace planescope::draw {
namespace {

using testing::toy_room;
using testing::ToyScene;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) / static_cast<double>(1ULL << 53);
}

std::vector<Eigen::Vector3f> random_points(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 500; ++i) {
    points.emplace_back(
        Eigen::Vector3d(4 * uniform(random) + 10, 2 * uniform(random) - 5, uniform(random))
            .cast<float>());
  }
  return points;
}

struct Extent {
  Eigen::Array2d low = Eigen::Array2d::Constant(9), high = Eigen::Array2d::Constant(-9);
};

Extent extent(const Camera& camera, double aspect, const std::vector<Eigen::Vector3f>& points) {
  Extent extent;
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d seen = project(camera, aspect, p.cast<double>());
    EXPECT_GT(seen.z(), 0);
    extent.low = extent.low.min(seen.head<2>().array());
    extent.high = extent.high.max(seen.head<2>().array());
  }
  return extent;
}

TEST(Camera, projects_by_hand) {
  Camera camera;  // at the origin, looking along +z, up +y: x points to the left
  camera.view_angle = 90;
  const Eigen::Vector3d seen = project(camera, 2, {-1, 1, 2});
  EXPECT_NEAR(seen.x(), 0.25, 1e-12);
  EXPECT_NEAR(seen.y(), 0.5, 1e-12);
  EXPECT_NEAR(seen.z(), 2, 1e-12);
}

TEST(Camera, fits_tightly_along_any_direction) {
  const std::vector<Eigen::Vector3f> points = random_points(4);
  const Frame frame{-0.9, 0.95, -0.8, 0.7};
  for (const Eigen::Vector3d& forward :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 2, -1), Eigen::Vector3d(0.2, -1, 0.3)}) {
    for (const double aspect : {0.4, 1.0, 2.5}) {
      const Camera camera = fit_along(points, forward, Eigen::Vector3d::UnitZ(), 30, aspect, frame);
      const Extent seen = extent(camera, aspect, points);
      constexpr double kRounding = 1e-6;
      EXPECT_GE(seen.low.x(), frame.left - kRounding);
      EXPECT_LE(seen.high.x(), frame.right + kRounding);
      EXPECT_GE(seen.low.y(), frame.bottom - kRounding);
      EXPECT_LE(seen.high.y(), frame.top + kRounding);
      // Tight: along one axis both sides are touched.
      const bool across = seen.low.x() < frame.left + 1e-4 && seen.high.x() > frame.right - 1e-4;
      const bool up = seen.low.y() < frame.bottom + 1e-4 && seen.high.y() > frame.top - 1e-4;
      EXPECT_TRUE(across || up);
    }
  }
}

TEST(Camera, from_a_place_holds_all_points) {
  const std::vector<Eigen::Vector3f> points = random_points(5);
  for (const double aspect : {0.5, 1.7}) {
    const Frame frame;
    const Camera camera = fit_from(points, {0, 0, 3}, Eigen::Vector3d::UnitZ(), aspect, frame);
    EXPECT_EQ(camera.position, Eigen::Vector3d(0, 0, 3));
    const Extent seen = extent(camera, aspect, points);
    EXPECT_LE(std::max(seen.high.maxCoeff(), -seen.low.minCoeff()), 0.97 + 1e-6);
    EXPECT_GT(std::max(seen.high.maxCoeff(), -seen.low.minCoeff()), 0.9);
  }
}

/// The toy room as a camera in it would see it: x right, y down, z forward.
ToyScene in_camera_frame() {
  ToyScene toy = toy_room();
  Eigen::Matrix3f turn;  // looking along +y of the room, from its middle
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Eigen::Vector3f eye(2, -4, 1.2F);
  for (Eigen::Vector3f& p : toy.cloud.positions) p = turn * (p - eye);
  for (Patch& patch : toy.scene.graph.patches) {
    patch.centroid = turn * (patch.centroid - eye);
    patch.normal = turn * patch.normal;
  }
  for (SupportingPlane& plane : toy.scene.planes) {
    plane.plane.distance -= plane.plane.normal.dot(eye);
    plane.plane.normal = turn * plane.plane.normal;
  }
  toy.cloud.width = 1;  // organised, so that the prior is a camera frame
  toy.cloud.height = static_cast<std::uint32_t>(toy.cloud.size());
  return toy;
}

TEST(Views, stand_upright_in_maps_and_in_camera_frames) {
  for (const bool camera_frame : {false, true}) {
    const ToyScene toy = camera_frame ? in_camera_frame() : toy_room();
    const SceneData scene = scene_data(toy.scene, toy.cloud);
    const SceneFrame frame = scene_frame(scene, {});
    const Eigen::Vector3d gravity_up =
        camera_frame ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
    EXPECT_GT(frame.up.dot(gravity_up), 0.99);
    EXPECT_NEAR(frame.front.dot(frame.up), 0, 1e-6);
    for (const View view : {View::Auto, View::Iso, View::Front, View::Left}) {
      const Camera camera = choose_view(view, scene, frame).fit(toy.cloud.positions, 1.5, {});
      // Something above something else is seen above it.
      const Eigen::Vector3d middle = camera.position + 3 * camera.forward();
      const Eigen::Vector3d below = project(camera, 1.5, middle);
      const Eigen::Vector3d above = project(camera, 1.5, middle + 0.3 * gravity_up);
      EXPECT_GT(above.y(), below.y() + 0.01);
      EXPECT_NEAR(above.x(), below.x(), 1e-6);
    }
    const Camera top = choose_view(View::Top, scene, frame).fit(toy.cloud.positions, 1.5, {});
    EXPECT_GT(top.forward().dot(-gravity_up), 0.999);
  }
}

TEST(Views, auto_stands_at_the_sensor_of_an_organised_cloud) {
  const ToyScene toy = in_camera_frame();
  const SceneData scene = scene_data(toy.scene, toy.cloud);
  const Viewpoint view = choose_view(View::Auto, scene, scene_frame(scene, {}));
  ASSERT_TRUE(view.position.has_value());
  EXPECT_EQ(*view.position, Eigen::Vector3d::Zero());
  EXPECT_GT(view.forward.z(), 0.9);
}

TEST(Views, cut_away_the_two_walls_before_the_camera_and_nothing_else) {
  const ToyScene toy = toy_room();
  const SceneData scene = scene_data(toy.scene, toy.cloud);
  const SceneFrame frame = scene_frame(scene, {});
  const Camera camera = choose_view(View::Iso, scene, frame).fit(toy.cloud.positions, 1.5, {});
  const Cutaway cut(scene, frame, camera.position);
  ASSERT_TRUE(cut.any());
  const Eigen::Vector3f inside(2, 1.5F, 1);
  EXPECT_FALSE(cut.hides(inside, kNone));
  EXPECT_FALSE(cut.hides({2, 1.5F, 0}, 0)) << "the floor stays";
  EXPECT_FALSE(cut.hides({2, 1.5F, 0.75F}, 5)) << "the table stays";
  int cut_walls = 0;
  for (std::int32_t wall = 1; wall <= 4; ++wall) {
    const Plane& plane = toy.scene.planes[static_cast<std::size_t>(wall)].plane;
    const bool before =
        plane.signed_distance(camera.position.cast<float>()) < 0;  // seen from behind
    const Eigen::Vector3f on_wall = inside - plane.signed_distance(inside) * plane.normal;
    EXPECT_EQ(cut.hides(on_wall, wall), before) << wall;
    EXPECT_EQ(cut.hides(on_wall, kNone), before) << "what hangs on wall " << wall;
    cut_walls += before ? 1 : 0;
  }
  EXPECT_EQ(cut_walls, 2);
}

TEST(Views, lifting_does_not_move_what_is_seen) {
  Camera camera;
  camera.position = {1, 2, 3};
  camera.focal = {4, 4, 4};
  camera.up = level(Eigen::Vector3d::UnitZ(), camera.forward());
  const Eigen::Vector3d p(5, 4.5, 4);
  const Eigen::Vector3d up = lifted(p, camera.position, 0.2);
  EXPECT_NEAR((up - p).norm(), 0.2, 1e-12);
  EXPECT_NEAR((project(camera, 1.5, up) - project(camera, 1.5, p)).head<2>().norm(), 0, 1e-12);
  EXPECT_LT((up - camera.position).norm(), (p - camera.position).norm());
}

TEST(Views, cut_away_a_wall_whose_normals_point_the_wrong_way) {
  ToyScene toy = toy_room();
  for (Patch& patch : toy.scene.graph.patches) patch.normal = -patch.normal;
  const SceneData scene = scene_data(toy.scene, toy.cloud);
  const SceneFrame frame = scene_frame(scene, {});
  const Cutaway cut(scene, frame, {2, -8, 5});  // before the wall y = 0, above
  EXPECT_TRUE(cut.hides({2, 0, 1}, 3));
  EXPECT_FALSE(cut.hides({2, 3, 1}, 4));
  EXPECT_FALSE(cut.hides({2, 1.5F, 0}, 0));
}

TEST(Views, a_picture_is_fitted_to_the_room_and_not_to_strays) {
  ToyScene toy = toy_room();
  const SceneFrame frame = scene_frame(scene_data(toy.scene, toy.cloud), {});
  const auto extent_of = [&] {
    const SceneData scene = scene_data(toy.scene, toy.cloud);
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& p : points_to_fit(scene.result, frame, {})) box.extend(p);
    return Eigen::Vector3f(box.sizes());
  };
  EXPECT_LT((extent_of() - Eigen::Vector3f(4, 3, 2.4F)).cwiseAbs().maxCoeff(), 0.02F);
  for (std::size_t i = 0; i < toy.cloud.size(); i += 250)  // 0.4 % look out of a window
    toy.cloud.positions[i].x() += 10;
  EXPECT_LT((extent_of() - Eigen::Vector3f(4, 3, 2.4F)).cwiseAbs().maxCoeff(), 0.02F);
}

TEST(SensorNoise, is_what_a_view_of_a_wall_was_given) {
  PointCloud cloud;
  cloud.width = 60;
  cloud.height = 40;
  std::mt19937_64 random(5);
  for (const float noise : {0.0F, 0.001F, 0.003F}) {
    cloud.positions.clear();
    for (std::size_t i = 0; i < 2400; ++i) {
      const float x = static_cast<float>(i % 60) / 60 - 0.5F;
      const float y = static_cast<float>(i / 60) / 40 - 0.5F;
      // A slanted wall, z = 3 + 2 X: along a row 1 / z is linear. Every third depth is off.
      float z = 3 / (1 - 2 * x * 0.3F);
      if (random() % 3 == 0) z *= 1 + noise * z;
      cloud.positions.emplace_back(x * z, y * z, z);
    }
    const double measured = depth_noise(cloud, {0, 0, 0}, {0, 0, 1});
    EXPECT_GE(measured, 0.9 * static_cast<double>(noise));  // the 95th percentile of departures
    EXPECT_LE(measured, 1.2 * static_cast<double>(noise) + 1e-6);
  }
  cloud.width = 2400;
  cloud.height = 1;
  EXPECT_EQ(depth_noise(cloud, {0, 0, 0}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace planescope::draw
