// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "synthesis_fixtures.hpp"
#include "synthesize/room.hpp"

namespace planescope {
namespace {

using namespace testing;
using Eigen::Vector3d;
using synthesis::Scene;
using synthesis::Solid;

std::map<std::string, int> count_kinds(const std::vector<std::string>& objects) {
  std::map<std::string, int> counts;
  for (const std::string& object : objects) ++counts[kind_of(object)];
  return counts;
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

}  // namespace
}  // namespace planescope
