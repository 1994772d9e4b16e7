// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/synthesize.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "synthesize/room.hpp"
#include "synthesize/sampling.hpp"

namespace planescope {
namespace {

using Eigen::Vector3d;
using synthesis::Scene;
using synthesis::Solid;

SynthesisOptions evenly(std::uint64_t seed, std::uint64_t points) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.points = points;
  return options;
}

SynthesisOptions seen(std::uint64_t seed, std::uint32_t views) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.views = views;
  return options;
}

// `chair 3` -> `chair`.
std::string kind_of(const std::string& object) { return object.substr(0, object.find(' ')); }

bool is_round(const std::string& object) {
  return std::set<std::string>{"ball", "bin", "cup", "lamp"}.contains(kind_of(object));
}

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

std::map<std::uint32_t, std::vector<const TruePlane*>> planes_by_label(
    const SynthesizedScene& scene) {
  std::map<std::uint32_t, std::vector<const TruePlane*>> planes;
  for (const TruePlane& plane : scene.planes) planes[plane.label].push_back(&plane);
  return planes;
}

float nearest_plane(const Eigen::Vector3f& p, const std::vector<const TruePlane*>& planes) {
  float nearest = std::numeric_limits<float>::infinity();
  for (const TruePlane* plane : planes) {
    nearest = std::min(nearest, std::abs(plane->plane.signed_distance(p)));
  }
  return nearest;
}

std::map<std::string, int> count_kinds(const std::vector<std::string>& objects) {
  std::map<std::string, int> counts;
  for (const std::string& object : objects) ++counts[kind_of(object)];
  return counts;
}

TEST(Synthesize, GivesExactlyTheNumberOfPoints) {
  for (const std::uint64_t points : {1u, 7u, 999u, 70'001u, 300'000u}) {
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
    SynthesisOptions options = evenly(5, 150'000);
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
    SynthesisOptions options = evenly(seed, 40'000);
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
    for (double z = 0.0005; z < synthesis::kHiddenGap; z += 0.001) {
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

TEST(Synthesize, RoomsAreFurnishedAsPromised) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const synthesis::Room room = synthesis::make_room(seed, false);
    std::map<std::string, int> count = count_kinds(room.scene.objects());
    const auto within = [](int value, int low, int high) { return value >= low && value <= high; };
    EXPECT_TRUE(within(count["table"], 2, 3)) << seed;
    EXPECT_TRUE(within(count["chair"], 3, 6)) << seed;
    EXPECT_TRUE(within(count["box"], 4, 8)) << seed;
    EXPECT_TRUE(within(count["shelf"], 1, 2)) << seed;
    EXPECT_TRUE(within(count["ball"], 2, 4)) << seed;
    EXPECT_TRUE(within(count["bin"] + count["cup"] + count["lamp"], 2, 4)) << seed;
    EXPECT_EQ(count["bed"], 1) << seed;
    EXPECT_EQ(count["cupboard"], 1) << seed;
    EXPECT_EQ(count["wall"], 4) << seed;
    EXPECT_TRUE(room.half.x() >= 2 && room.half.x() <= 3.5) << seed;
    EXPECT_TRUE(room.half.y() >= 1.75 && room.half.y() <= 3) << seed;
    EXPECT_TRUE(room.half.z() >= 1.2 && room.half.z() <= 1.4) << seed;
  }
}

TEST(Synthesize, FurnitureDoesNotInterpenetrate) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = synthesis::make_room(seed, true).scene;
    std::vector<std::uint32_t> label(scene.solids().size());
    for (const synthesis::Surface& surface : scene.surfaces()) label[surface.solid] = surface.label;
    for (std::size_t a = 0; a < label.size(); ++a) {
      for (int i = 0; i < 200; ++i) {  // points inside solid a, or at least inside its box
        const double x = unit(random), y = unit(random), z = unit(random);
        const Solid& solid = scene.solids()[a];
        const Vector3d p = solid.pose * Vector3d(Vector3d(x, y, z).cwiseProduct(solid.half));
        if (!solid.contains(p, 0)) continue;
        for (std::size_t b = 0; b < label.size(); ++b) {
          if (label[b] == label[a]) continue;
          const bool structures = label[a] <= 6 && label[b] <= 6;  // slabs meet at the corners
          ASSERT_TRUE(structures || !scene.solids()[b].contains(p, -1e-6))
              << seed << ": " << scene.objects()[label[a] - 1] << ", "
              << scene.objects()[label[b] - 1];
        }
      }
    }
  }
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

TEST(Synthesize, OneViewIsAnOrganisedImageInTheCamerasFrame) {
  SynthesisOptions options = seen(1, 1);
  options.normals = true;
  const SynthesizedScene scene = synthesize(options);
  const PointCloud& cloud = scene.cloud;
  ASSERT_EQ(cloud.width, 640u);
  ASSERT_EQ(cloud.height, 480u);
  ASSERT_EQ(cloud.size(), 640u * 480u);
  ASSERT_TRUE(cloud.sensor.has_value());
  EXPECT_EQ(*cloud.sensor, Eigen::Vector3f(0, 0, 0));
  const auto planes = planes_by_label(scene);
  std::size_t returns = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    ASSERT_EQ(is_finite(p), cloud.labels[i] != 0);
    if (!is_finite(p)) continue;
    ++returns;
    ASSERT_NEAR(525 * p.x() / p.z() + 319.5f, static_cast<float>(i % 640), 1e-3f);
    ASSERT_NEAR(525 * p.y() / p.z() + 239.5f, static_cast<float>(i / 640), 1e-3f);
    ASSERT_GE(p.z(), 0.5f);
    ASSERT_LE(p.z(), 6.0f);
    ASSERT_LT(cloud.normals[i].dot(p), 0) << "a normal looks away from the camera";
    if (is_round(scene.objects[cloud.labels[i] - 1])) continue;
    ASSERT_LT(nearest_plane(p, planes.at(cloud.labels[i])), 0.002f * 6 * p.z() * p.z() + 1e-4f);
  }
  EXPECT_GT(returns, 640u * 480u / 2);
}

TEST(Synthesize, DepthNoiseGrowsWithTheSquareOfDepth) {
  SynthesisOptions options = seen(3, 1);
  options.noise = 0;
  const SynthesizedScene clean = synthesize(options);
  options.noise = 0.004;
  const SynthesizedScene noisy = synthesize(options);
  double near = 0, near_count = 0, far = 0, far_count = 0;
  for (std::size_t i = 0; i < clean.cloud.size(); ++i) {
    const double z = static_cast<double>(clean.cloud.positions[i].z());
    const double error = (static_cast<double>(noisy.cloud.positions[i].z()) - z) / (z * z);
    if (!std::isfinite(error)) continue;
    (z < 2.5 ? near : far) += error * error;
    (z < 2.5 ? near_count : far_count) += 1;
  }
  ASSERT_GT(near_count, 5000);
  ASSERT_GT(far_count, 5000);
  EXPECT_NEAR(std::sqrt(near / near_count), 0.004, 0.0002);
  EXPECT_NEAR(std::sqrt(far / far_count), 0.004, 0.0002);
}

TEST(Synthesize, ManyViewsShareTheRoomsFrame) {
  SynthesisOptions options = seen(2, 6);
  options.normals = true;
  const SynthesizedScene scene = synthesize(options);
  const PointCloud& cloud = scene.cloud;
  EXPECT_FALSE(cloud.organised());
  EXPECT_EQ(cloud.width, cloud.size());
  EXPECT_GT(cloud.size(), 6u * 640 * 480 / 2);
  ASSERT_EQ(scene.planes.front().name, "floor");
  EXPECT_LT((scene.planes.front().plane.normal - Eigen::Vector3f::UnitZ()).norm(), 1e-6f);
  const double whole = synthesize(evenly(2, 1)).planes.front().area;
  EXPECT_GT(scene.planes.front().area, whole / 4);
  EXPECT_LT(scene.planes.front().area, whole * 1.1);
  const auto planes = planes_by_label(scene);
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    ASSERT_TRUE(is_finite(cloud.positions[i]));
    ASSERT_NEAR(cloud.normals[i].norm(), 1, 1e-5);
    if (is_round(scene.objects[cloud.labels[i] - 1])) continue;
    ASSERT_LT(nearest_plane(cloud.positions[i], planes.at(cloud.labels[i])), 0.002 * 6 * 36);
  }
}

TEST(Synthesize, TruthSurvivesItsFile) {
  const testing::TemporaryFolder folder;
  SynthesisOptions options = evenly(9, 100);
  options.offset = Vector3d(1000, 2000, -3);
  const SynthesizedScene scene = synthesize(options);
  write_truth(scene, folder / "truth.json");
  const std::vector<TruePlane> same = read_true_planes(folder / "truth.json", scene.cloud.origin);
  const std::vector<TruePlane> world = read_true_planes(folder / "truth.json");
  ASSERT_EQ(same.size(), scene.planes.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].name, scene.planes[i].name);
    EXPECT_EQ(same[i].label, scene.planes[i].label);
    EXPECT_EQ(same[i].area, scene.planes[i].area);
    EXPECT_EQ(same[i].structural, scene.planes[i].structural);
    EXPECT_EQ(same[i].plane.normal, scene.planes[i].plane.normal);
    EXPECT_EQ(same[i].plane.distance, scene.planes[i].plane.distance);
    EXPECT_EQ(same[i].centroid, scene.planes[i].centroid);
    EXPECT_NEAR(world[i].plane.signed_distance(world[i].centroid), 0, 1e-3);
    EXPECT_LT((world[i].centroid - same[i].centroid - Eigen::Vector3f(1000, 2000, -3)).norm(),
              1e-3f);
  }
}

TEST(Synthesize, MalformedTruthIsRefusedWithAReason) {
  const testing::TemporaryFolder folder;
  const std::string head = R"({"format":"planescope-truth","version":1,"origin":[0,0,0],"planes":)";
  const auto plane = [&](const std::string& label, const std::string& normal,
                         const std::string& area, const std::string& distance) {
    return head + R"([{"name":"a","structural":true,"centroid":[0,0,0],"label":)" + label +
           R"(,"normal":)" + normal + R"(,"area":)" + area + R"(,"distance":)" + distance + "}]}";
  };
  const auto message_for = [&](const std::string& text) -> std::string {
    testing::write_bytes(folder / "t.json", text);
    try {
      read_true_planes(folder / "t.json");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Input);
      return error.what();
    }
    return "accepted";
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos && text.find('\n') == std::string::npos;
  };
  EXPECT_EQ(message_for(plane("1", "[0,0,1]", "2", "0.5")), "accepted");
  EXPECT_TRUE(contains(message_for(""), "not JSON at byte"));
  EXPECT_TRUE(contains(message_for("{\"format\":"), "not JSON at byte"));
  EXPECT_TRUE(contains(message_for("[]"), "no member \"format\""));
  EXPECT_TRUE(contains(message_for(R"({"format":"x"})"), "is not \"planescope-truth\""));
  EXPECT_TRUE(contains(message_for(head + "7}"), "\"planes\" is not a list"));
  EXPECT_TRUE(contains(message_for(head + "[7]}"), "planes[0]: no member \"name\""));
  EXPECT_TRUE(contains(message_for(plane("-1", "[0,0,1]", "2", "0")), "planes[0].label"));
  EXPECT_TRUE(contains(message_for(plane("4294967296", "[0,0,1]", "2", "0")), "planes[0].label"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,2]", "2", "0")), "not of length 1"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,1]", "2", "0")), "list of 3 numbers"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "-2", "0")), "area is negative"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "1e300")), "not within 1e9"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "1e400")), "out of range"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "null")), "is not a number"));
  EXPECT_TRUE(contains(message_for(std::string(100'000, '[')), "not JSON"));
  EXPECT_THROW(read_true_planes(folder / "absent.json"), Error);
  EXPECT_THROW(read_true_planes(folder.path()), Error);
  EXPECT_THROW(write_truth({}, folder / "no such folder" / "t.json"), Error);
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
