// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "io_bytes.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/result.hpp"
#include "toy_clouds.hpp"

/// \file Scenes that are none, and options at the ends of their ranges: an answer that holds
/// together, or a refusal in words; never a crash, never a wait.
namespace planescope {
namespace {

using testing::make_box_room;
using testing::Uniform;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kMax = std::numeric_limits<float>::max();

PointCloud cloud_of(std::vector<Eigen::Vector3f> positions) {
  PointCloud cloud;
  cloud.width = static_cast<std::uint32_t>(positions.size());
  cloud.positions = std::move(positions);
  return cloud;
}

PointCloud random_points(std::size_t count, float size) {
  Uniform uniform(3);
  std::vector<Eigen::Vector3f> positions(count);
  for (Eigen::Vector3f& p : positions) p = size * Eigen::Vector3f(uniform(), uniform(), uniform());
  return cloud_of(std::move(positions));
}

PointCloud scaled_room(float factor) {
  PointCloud cloud = make_box_room(400);
  for (Eigen::Vector3f& p : cloud.positions) p *= factor;
  return cloud;
}

PointCloud with_strays(std::vector<Eigen::Vector3f> strays) {
  PointCloud cloud = make_box_room(400);
  cloud.positions.insert(cloud.positions.end(), strays.begin(), strays.end());
  cloud.labels.clear();
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  return cloud;
}

/// All that the parts of a segmentation promise each other.
void expect_whole(const Segmentation& scene, const PointCloud& cloud) {
  ASSERT_EQ(scene.point_label.size(), cloud.size());
  ASSERT_EQ(scene.point_plane.size(), cloud.size());
  ASSERT_EQ(scene.patch_plane.size(), scene.graph.patches.size());
  ASSERT_EQ(scene.edges.size(), scene.graph.adjacency.size());
  for (const std::uint32_t label : scene.point_label)
    ASSERT_LE(label, scene.segments.segments.size());
  for (const std::int32_t plane : scene.point_plane)
    ASSERT_LT(plane, static_cast<std::int32_t>(scene.planes.size()));
  for (const SupportingPlane& plane : scene.planes) {
    EXPECT_NEAR(plane.plane.normal.norm(), 1, 1e-3);
    EXPECT_TRUE(std::isfinite(plane.plane.distance) && std::isfinite(plane.area));
  }
  for (const Segment& s : scene.segments.segments) EXPECT_TRUE(is_finite(s.centroid));
  const Result result = make_result(scene, cloud);
  EXPECT_EQ(result.point_label, scene.point_label);
}

/// The refusal of one of the presets, or the empty text after an answer that holds together.
std::string outcome(const PointCloud& cloud, const std::function<Options()>& options) {
  try {
    expect_whole(segment(cloud, options()), cloud);
    return {};
  } catch (const Error& error) {
    EXPECT_NE(error.kind(), Error::Kind::Internal) << error.what();
    return error.what();
  }
}

struct Scene {
  std::string name;
  std::function<PointCloud()> make;
  std::string refusal;  ///< part of what every preset says; empty: an answer
};

void PrintTo(const Scene& scene, std::ostream* out) { *out << scene.name; }

std::vector<Scene> scenes() {
  const auto along = [](const Eigen::Vector3f& direction) {
    std::vector<Eigen::Vector3f> positions;
    for (int i = 0; i < 5000; ++i) positions.push_back(float(i) * 0.001F * direction);
    return cloud_of(positions);
  };
  return {
      {"none", [] { return PointCloud(); }, "no finite point"},
      {"one", [] { return random_points(1, 1); }, ""},
      {"two", [] { return random_points(2, 1); }, ""},
      {"three", [] { return random_points(3, 1); }, ""},
      {"equal", [] { return cloud_of(std::vector(20'000, Eigen::Vector3f(1, 2, 3))); }, ""},
      {"million_equal", [] { return cloud_of(std::vector(1'000'000, Eigen::Vector3f(1, 2, 3))); },
       ""},
      {"line", [=] { return along(Eigen::Vector3f::UnitX()); }, ""},
      {"slanted_line", [=] { return along(Eigen::Vector3f::Ones()); }, ""},
      {"all_missing", [] { return cloud_of(std::vector(1000, Eigen::Vector3f(kNan, 0, 0))); },
       "no finite point"},
      {"tiny", [] { return scaled_room(1e-4F); }, ""},
      {"subnormal", [] { return scaled_room(1e-41F); }, ""},
      {"millimetres_of_space", [] { return scaled_room(1e35F); }, " m"},
      {"far_apart",
       [] {
         return cloud_of({{0, 0, 0}, {kMax, kMax, kMax}, {-kMax, 0, 0}});
       },
       " m"},
      {"stray",
       [] {
         return with_strays({{1e9F, 0, 0}});
       },
       ""},
      {"strays",
       [] {
         return with_strays({{kMax, -kMax, kMax}, {0, 0, -1e30F}});
       },
       ""},
      {"half_elsewhere",
       [] {
         PointCloud cloud = make_box_room(400);
         for (std::size_t i = 0; i < cloud.size(); i += 2) cloud.positions[i].x() += 1e6F;
         return cloud;
       },
       " m"},
      {"no_neighbours", [] { return random_points(3000, 30); }, ""},
      {"infinite_normals",
       [] {
         PointCloud cloud = make_box_room(400);
         cloud.normals.assign(cloud.size(), Eigen::Vector3f(kNan, kMax, 0));
         return cloud;
       },
       ""},
      {"wrong_normals",
       [] {
         PointCloud cloud = make_box_room(400);
         cloud.normals.assign(cloud.size(), Eigen::Vector3f::Zero());
         return cloud;
       },
       ""},
      {"sensor_inside_a_point",
       [] {
         PointCloud cloud = make_box_room(400);
         cloud.sensor = cloud.positions.front();
         return cloud;
       },
       ""},
  };
}

class Degenerate : public ::testing::TestWithParam<Scene> {};

TEST_P(Degenerate, IsAnsweredOrRefused) {
  const PointCloud cloud = GetParam().make();
  for (const auto& options : {std::function(Options::room), std::function(Options::tabletop)}) {
    const std::string said = outcome(cloud, options);
    EXPECT_EQ(said.empty(), GetParam().refusal.empty()) << said;
    EXPECT_NE(said.find(GetParam().refusal), std::string::npos) << said;
  }
  outcome(cloud, [&] { return Options::automatic(cloud); });  // may refuse more, in words
}

INSTANTIATE_TEST_SUITE_P(Scenes, Degenerate, ::testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(DegenerateStrays, AreLeftOutAndChangeNothing) {
  PointCloud clean = with_strays({});
  const PointCloud strays = with_strays({{1e9F, 0, 0}, {0, 0, -2e9F}});
  for (const Options& options : {Options::room(), Options::automatic(clean)}) {
    const Segmentation before = segment(clean, options), after = segment(strays, options);
    EXPECT_EQ(after.graph.stray_points, 2U);
    EXPECT_EQ(before.graph.stray_points, 0U);
    EXPECT_EQ(after.point_label[clean.size()], kNoSegment);
    EXPECT_TRUE(std::equal(before.point_label.begin(), before.point_label.end(),
                           after.point_label.begin()));
  }
  const Options a = Options::automatic(clean), b = Options::automatic(strays);
  EXPECT_NEAR(a.patches.voxel_size, b.patches.voxel_size, 0.05 * a.patches.voxel_size);
}

TEST(DegenerateScale, IsSaid) {
  const PointCloud room = make_box_room(400);
  const PointCloud millimetres = scaled_room(1000);
  const CloudScale metres = measure_scale(room);
  EXPECT_EQ(scale_warning(metres, Options::automatic(room)), "");
  EXPECT_NE(scale_warning(metres, Options::tabletop()).find("further than --voxel-size"),
            std::string::npos);
  const std::string said = scale_warning(measure_scale(millimetres), Options::room());
  EXPECT_NE(said.find("look like millimetres"), std::string::npos) << said;
}

// 100,000 components of a few points each.
TEST(DegenerateComponents, ManyTinyOnes) {
  PointCloud cloud;
  for (int i = 0; i < 100'000; ++i) {
    const Eigen::Vector3f corner(float(i % 50), float(i / 50 % 50), float(i / 2500));
    for (int k = 0; k < 4; ++k)
      cloud.positions.push_back(0.5F * corner +
                                0.03F * Eigen::Vector3f(float(k & 1), float(k >> 1), 0));
  }
  cloud.width = static_cast<std::uint32_t>(cloud.size());
  const Segmentation scene = segment(cloud, Options::room());
  expect_whole(scene, cloud);
  EXPECT_GE(scene.segments.segments.size(), 100'000U);
}

std::vector<std::string> ends_of_ranges() {
  std::vector<std::string> all;
  for (const OptionInfo& info : option_table()) {
    const std::size_t to = info.range.find(" to ");
    if (to == std::string::npos) continue;
    all.push_back(info.name + "=" + info.range.substr(0, to));
    all.push_back(info.name + "=" + info.range.substr(to + 4));
  }
  return all;
}

class ExtremeOptions : public ::testing::TestWithParam<std::string> {};

TEST_P(ExtremeOptions, AreAnsweredOrRefused) {
  const PointCloud cloud = make_box_room(200);
  const std::size_t split = GetParam().find('=');
  outcome(cloud, [&] {
    Options options = Options::room();
    options.patches.voxel_size = 0.1;
    options.patches.patch_size = 0.3;
    set_option(options, GetParam().substr(0, split), GetParam().substr(split + 1));
    return options;
  });
}

INSTANTIATE_TEST_SUITE_P(Ends, ExtremeOptions, ::testing::ValuesIn(ends_of_ranges()));

}  // namespace
}  // namespace planescope
