// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/project.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/pipeline.hpp"
#include "synthesize/camera.hpp"
#include "synthesize/room.hpp"
#include "synthesize/views.hpp"

namespace planescope {
namespace {

using Labels = std::vector<std::uint32_t>;

/// 4 x 2 pixels; a point (x, y, z) is seen at column 2 x / z + 1, row 2 y / z.
PinholeCamera small_camera() {
  PinholeCamera camera{4, 2, 2, 2, 1, 0};
  return camera;
}

PointCloud cloud_of(const std::vector<Eigen::Vector3f>& positions) {
  PointCloud cloud;
  cloud.positions = positions;
  cloud.width = static_cast<std::uint32_t>(positions.size());
  return cloud;
}

TEST(ProjectLabels, NearestPointWinsAndHolesAreUnlabelled) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const PointCloud cloud = cloud_of({{0, 0, 2},      // column 1, row 0
                                     {0, 0, 1},      // the same pixel, nearer
                                     {0, 0, 3},      // the same pixel, farther
                                     {1, 1, 2},      // column 2, row 1
                                     {0.74F, 0, 1},  // column 2.48: 2
                                     {0.76F, 0, 1},  // column 2.52: 3
                                     {0, 0, -1},     // behind the camera
                                     {5, 0, 1},      // outside
                                     {kNan, 0, 1}});
  const Labels found = project_labels(cloud, Labels{1, 2, 3, 4, 5, 6, 7, 8, 9}, small_camera());
  EXPECT_EQ(found, (Labels{0, 2, 5, 6,  //
                           0, 0, 4, 0}));
}

TEST(ProjectLabels, UnlabelledPointsHideOthersAndTheFirstOfEqualsStays) {
  const PointCloud cloud = cloud_of({{0, 0, 2}, {0, 0, 1}, {0.5F, 0, 1}, {0.5F, 0, 1}});
  EXPECT_EQ(project_labels(cloud, Labels{1, 0, 3, 4}, small_camera()),
            (Labels{0, 0, 3, 0, 0, 0, 0, 0}));
}

TEST(ProjectLabels, APointCoversItsRadius) {
  const PointCloud cloud = cloud_of({{0, 0, 2}, {0.5F, 0, 1}});
  EXPECT_EQ(project_labels(cloud, Labels{1, 2}, small_camera(), 1),
            (Labels{1, 2, 2, 2, 1, 2, 2, 2}));
}

TEST(ProjectLabels, PoseAndOriginMoveTheWorld) {
  PinholeCamera camera = small_camera();
  camera.pose.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  camera.pose.translation() << 5000, 2, 3;  // looks along +x of the world
  PointCloud cloud = cloud_of({{2, 0, 0}, {2, 1, 0}});
  cloud.origin = {5000, 2, 3};
  EXPECT_EQ(project_labels(cloud, Labels{1, 2}, camera), (Labels{0, 1, 0, 0, 0, 2, 0, 0}));
}

TEST(ProjectLabels, RefusesWhatMakesNoImage) {
  const PointCloud cloud = cloud_of({{0, 0, 1}});
  const auto refused = [&](const Labels& labels, PinholeCamera camera, std::uint32_t radius = 0) {
    try {
      project_labels(cloud, labels, camera, radius);
    } catch (const Error& error) {
      return static_cast<int>(error.kind());
    }
    return 0;
  };
  EXPECT_EQ(refused({}, small_camera()), static_cast<int>(Error::Kind::Input));
  EXPECT_EQ(refused({1}, {0, 2, 2, 2, 0, 0}), static_cast<int>(Error::Kind::Usage));
  EXPECT_EQ(refused({1}, {4, 2, -2, 2, 0, 0}), static_cast<int>(Error::Kind::Usage));
  EXPECT_EQ(refused({1}, {100'000, 100'000, 2, 2, 0, 0}), static_cast<int>(Error::Kind::Usage));
  EXPECT_EQ(refused({1}, small_camera(), 65), static_cast<int>(Error::Kind::Usage));
  EXPECT_EQ(refused({1}, small_camera()), 0);
}

/// A map that three depth cameras made, and which point each pixel of the first one became.
struct MappedRoom {
  PointCloud map, view;
  std::vector<std::int32_t> point_of_pixel;
  PinholeCamera camera;
};

MappedRoom map_room(std::uint64_t seed) {
  const synthesis::Room room = synthesis::make_room(seed, false);
  const synthesis::RayCaster caster(room.scene);
  SynthesisOptions options;
  options.random_seed = seed;
  MappedRoom made;
  std::uint64_t stream = 0;
  for (const synthesis::Camera& camera : synthesis::place_cameras(room, caster, seed, 3)) {
    const PointCloud view = synthesis::sense(
        room.scene, camera, synthesis::render_depth(caster, camera), options, stream);
    if (stream == 0) {
      made.view = view;
      made.point_of_pixel.assign(view.size(), kNone);
      made.camera = {640, 480, camera.focal, camera.focal, camera.cx, camera.cy, camera.pose};
    }
    for (std::size_t i = 0; i < view.size(); ++i) {
      if (!is_finite(view.positions[i])) continue;
      if (stream == 0) made.point_of_pixel[i] = static_cast<std::int32_t>(made.map.size());
      made.map.positions.push_back((camera.pose * view.positions[i].cast<double>()).cast<float>());
    }
    ++stream;
  }
  made.map.width = static_cast<std::uint32_t>(made.map.size());
  return made;
}

TEST(ProjectLabels, ScoresAsTheViewsOwnPixelsDo) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const MappedRoom room = map_room(seed);
    const Labels map = segment(room.map, Options::automatic(room.map)).point_label;
    Labels direct(room.view.size(), kNoSegment);
    for (std::size_t i = 0; i < direct.size(); ++i) {
      if (room.point_of_pixel[i] != kNone)
        direct[i] = map[static_cast<std::size_t>(room.point_of_pixel[i])];
    }
    const Labels projected = project_labels(room.map, map, room.camera);
    const LabelScores expected = score_labels(direct, room.view.labels);
    const LabelScores found = score_labels(projected, room.view.labels);
    EXPECT_NEAR(found.weighted_overlap, expected.weighted_overlap, 0.01) << seed;
    EXPECT_NEAR(found.overlap, expected.overlap, 0.01) << seed;
    EXPECT_NEAR(found.adjusted_rand, expected.adjusted_rand, 0.01) << seed;
    EXPECT_LT(expected.weighted_overlap, 0.999) << "the segmentation should not be trivial";
  }
}

}  // namespace
}  // namespace planescope
