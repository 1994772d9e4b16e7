// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/synthesize.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "planescope/error.hpp"
#include "synthesis_fixtures.hpp"
#include "synthesize/room.hpp"
#include "synthesize/sampling.hpp"

namespace planescope {
namespace {

using namespace testing;
using Eigen::Vector3d;
using synthesis::Scene;

// Everything of a scene as one string, to compare bit by bit.
std::string bytes_of(const SynthesizedScene& scene) {
  std::string bytes;
  const auto add = [&](const void* data, std::size_t size) {
    if (size > 0) bytes.append(static_cast<const char*>(data), size);
  };
  const PointCloud& cloud = scene.cloud;
  add(cloud.positions.data(), cloud.size() * sizeof(Eigen::Vector3f));
  add(cloud.normals.data(), cloud.normals.size() * sizeof(Eigen::Vector3f));
  add(cloud.colors.data(), cloud.colors.size() * sizeof(Rgb));
  add(cloud.labels.data(), cloud.labels.size() * sizeof(std::uint32_t));
  for (const TruePlane& plane : scene.planes) {
    bytes += plane.name;
    add(plane.plane.normal.data(), 3 * sizeof(float));
    add(&plane.plane.distance, sizeof(float));
    add(plane.centroid.data(), 3 * sizeof(float));
    add(&plane.area, sizeof(double));
  }
  return bytes;
}

TEST(Synthesize, GivesExactlyTheNumberOfPoints) {
  for (const std::uint64_t points : {1u, 7u, 70'001u, 150'000u}) {
    const SynthesizedScene scene = synthesize(evenly(2, points));
    ASSERT_EQ(scene.cloud.size(), points);
    EXPECT_EQ(scene.cloud.width, points);
    EXPECT_EQ(scene.cloud.height, 1u);
    EXPECT_EQ(scene.cloud.colors.size(), points);
    EXPECT_EQ(scene.cloud.labels.size(), points);
    EXPECT_TRUE(scene.cloud.normals.empty());
    for (std::size_t i = 0; i < points; ++i) {
      ASSERT_TRUE(is_finite(scene.cloud.positions[i]));
      ASSERT_GE(scene.cloud.labels[i], 1u);
      ASSERT_LE(scene.cloud.labels[i], scene.objects.size());
    }
  }
}

TEST(Synthesize, SameOptionsSameBytesAtAnyNumberOfThreads) {
  for (const std::uint32_t views : {0u, 1u, 2u}) {
    SynthesisOptions options = evenly(5, 70'000);
    options.views = views;
    options.normals = true;
    const std::string first = bytes_of(synthesize(options));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(first == bytes_of(synthesize(options))) << views << " views";
    options.random_seed = 6;
    EXPECT_FALSE(first == bytes_of(synthesize(options))) << views << " views";
  }
}

TEST(Synthesize, EveryPointLiesOnItsObject) {
  SynthesisOptions options = evenly(1, 60'000);
  options.normals = true;
  const SynthesizedScene scene = synthesize(options);
  const auto planes = planes_by_label(scene);
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    const std::uint32_t label = scene.cloud.labels[i];
    if (is_round(scene.objects[label - 1])) continue;
    ASSERT_LT(nearest_plane(scene.cloud.positions[i], planes.at(label)), 6 * options.noise + 1e-5)
        << scene.objects[label - 1];
    ASSERT_NEAR(scene.cloud.normals[i].norm(), 1, 1e-5);
  }
}

TEST(Synthesize, NoPointIsInsideOrPressedAgainstASolid) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SynthesisOptions options = evenly(seed, 15'000);
    options.noise = 0;
    options.normals = true;
    options.ceiling = true;
    const SynthesizedScene made = synthesize(options);
    const Scene scene = synthesis::make_room(seed, true).scene;
    for (std::size_t i = 0; i < made.cloud.size(); ++i) {
      const Vector3d p = made.cloud.positions[i].cast<double>();
      const Vector3d normal = made.cloud.normals[i].cast<double>();
      ASSERT_FALSE(scene.occupied(p, -1e-4)) << made.objects[made.cloud.labels[i] - 1];
      for (const double ahead : {0.002, 0.015, 0.03}) {
        ASSERT_FALSE(scene.occupied(p + ahead * normal, -1e-4))
            << made.objects[made.cloud.labels[i] - 1];
      }
    }
  }
}

TEST(Synthesize, DensityIsTheSameEverywhere) {
  const SynthesizedScene scene = synthesize(evenly(4, 200'000));
  std::vector<double> points(scene.objects.size() + 1), areas(scene.objects.size() + 1);
  for (const std::uint32_t label : scene.cloud.labels) ++points[label];
  for (const TruePlane& plane : scene.planes) areas[plane.label] += plane.area;
  const double density = points[1] / areas[1];  // of the floor
  for (std::uint32_t label = 2; label < points.size(); ++label) {
    if (is_round(scene.objects[label - 1])) continue;
    EXPECT_NEAR(points[label] / areas[label], density, 0.01 * density) << scene.objects[label - 1];
  }
}

TEST(Synthesize, AreaIsWhatIsFree) {
  // The floor's free area by throwing points at it and looking for solids in small steps upwards.
  const synthesis::Room room = synthesis::make_room(3, false);
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(-1, 1);
  constexpr int kThrows = 20'000;
  int free = 0;
  for (int i = 0; i < kThrows; ++i) {
    const double x = unit(random), y = unit(random);
    const Vector3d p = room.frame * Vector3d(x * room.half.x(), y * room.half.y(), 0);
    bool blocked = false;
    for (double z = 0.0005; z < synthesis::kHiddenGap; z += 0.003) {
      blocked = blocked || room.scene.occupied(p + Vector3d(0, 0, z), 0);
    }
    free += blocked ? 0 : 1;
  }
  const double expected = 4 * room.half.x() * room.half.y() * free / kThrows;
  const SynthesizedScene scene = synthesize(evenly(3, 1000));
  ASSERT_EQ(scene.planes.front().name, "floor");
  EXPECT_NEAR(scene.planes.front().area, expected, 0.015 * expected);
}

TEST(Synthesize, StructureIsComplete) {
  for (const bool ceiling : {false, true}) {
    SynthesisOptions options = evenly(8, 20'000);
    options.ceiling = ceiling;
    const SynthesizedScene scene = synthesize(options);
    std::set<std::string> names;
    for (const TruePlane& plane : scene.planes) {
      if (!plane.structural) continue;
      names.insert(plane.name);
      EXPECT_GT(std::count(scene.cloud.labels.begin(), scene.cloud.labels.end(), plane.label), 500);
      EXPECT_NEAR(plane.plane.signed_distance(plane.centroid), 0, 1e-5);
      const Eigen::Vector3f middle(0, 0, 1.2f);
      EXPECT_GT(plane.plane.signed_distance(middle), 1) << "faces the inside: " << plane.name;
      if (plane.name == "floor") {
        EXPECT_LT((plane.plane.normal - Eigen::Vector3f::UnitZ()).norm(), 1e-6f);
        EXPECT_NEAR(plane.plane.distance, 0, 1e-6);
      }
    }
    std::set<std::string> expected = {"floor", "wall 1", "wall 2", "wall 3", "wall 4"};
    if (ceiling) expected.insert("ceiling");
    EXPECT_EQ(names, expected);
  }
}

TEST(Synthesize, NoiseHasTheStandardDeviationThatWasAskedFor) {
  SynthesisOptions options = evenly(1, 100'000);
  options.noise = 0.01;
  const SynthesizedScene scene = synthesize(options);
  double sum = 0, squares = 0, count = 0;
  for (std::size_t i = 0; i < scene.cloud.size(); ++i) {
    if (scene.cloud.labels[i] != 1) continue;  // the floor, z = 0
    const double z = static_cast<double>(scene.cloud.positions[i].z());
    sum += z;
    squares += z * z;
    ++count;
  }
  EXPECT_NEAR(sum / count, 0, 4 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 0.0003);
}

TEST(Synthesize, WholeMetresOfTheOffsetBecomeTheOrigin) {
  SynthesisOptions options = evenly(2, 5000);
  const SynthesizedScene here = synthesize(options);
  options.offset = Vector3d(4'512'345.25, -3'000'000.5, 412);
  const SynthesizedScene there = synthesize(options);
  EXPECT_EQ(there.cloud.origin, Vector3d(4'512'345, -3'000'000, 412));
  for (std::size_t i = 0; i < here.cloud.size(); ++i) {
    const Vector3d moved =
        there.cloud.origin + there.cloud.positions[i].cast<double>() - options.offset;
    ASSERT_LT((moved - here.cloud.positions[i].cast<double>()).norm(), 2e-6);
  }
  const auto planes = planes_by_label(there);
  for (std::size_t i = 0; i < there.cloud.size(); ++i) {
    if (there.cloud.labels[i] > 5) continue;
    ASSERT_LT(nearest_plane(there.cloud.positions[i], planes.at(there.cloud.labels[i])), 0.013);
  }
  for (const TruePlane& plane : there.planes) {
    EXPECT_NEAR(plane.plane.signed_distance(plane.centroid), 0, 2e-6) << plane.name;
  }
}

TEST(Synthesize, RefusesWhatIsOutOfRange) {
  const auto message_for = [](auto&& change) -> std::string {
    SynthesisOptions options = evenly(1, 100);
    change(options);
    try {
      synthesize(options);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Usage);
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message_for([](auto& o) { o.points = 0; }),
            "synthesize: points is 0; expected 1 to 16000000");
  EXPECT_NE(message_for([](auto& o) { o.points = 16'000'001; }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.views = 1001; }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.noise = -0.001; }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.noise = 0.21; }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.noise = std::nan(""); }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.offset.y() = 2e9; }), "accepted");
  EXPECT_NE(message_for([](auto& o) { o.offset.x() = std::nan(""); }), "accepted");
}

TEST(Apportion, LargestRemainders) {
  using synthesis::apportion;
  using Shares = std::vector<std::uint64_t>;
  EXPECT_EQ(apportion(10, std::vector<double>{1, 1, 2}), (Shares{3, 2, 5}));  // 2.5, 2.5, 5
  EXPECT_EQ(apportion(1, std::vector<double>{1, 0, 3}), (Shares{0, 0, 1}));
  EXPECT_EQ(apportion(7, std::vector<double>{0, 5, 0}), (Shares{0, 7, 0}));
  const Shares shares = apportion(16'000'000, std::vector<double>(997, 0.1));
  EXPECT_EQ(std::accumulate(shares.begin(), shares.end(), std::uint64_t{0}), 16'000'000u);
}

}  // namespace
}  // namespace planescope
