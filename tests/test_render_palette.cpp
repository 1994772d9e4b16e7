// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "color_assignment.hpp"
#include "fixtures.hpp"
#include "image.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"
#include "point_layer.hpp"
#include "scene_data.hpp"
#include "test_render_scene.hpp"

/// \file Colours and pixels.
namespace planescope::draw {
namespace {

using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

TEST(Palette, oklab_of_known_colors) {  // reference values of Ottosson's article
  EXPECT_NEAR((to_oklab({255, 255, 255}) - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((to_oklab({255, 0, 0}) - Eigen::Vector3d(0.6280, 0.2249, 0.1258)).norm(), 0, 1e-3);
  EXPECT_NEAR((to_oklab({0, 0, 255}) - Eigen::Vector3d(0.4520, -0.0324, -0.3115)).norm(), 0, 1e-3);
  const Pixel sage = from_oklch(0.7, 0.08, 150);
  EXPECT_NEAR(to_oklab(sage).x(), 0.7, 0.01);
  EXPECT_NEAR(to_oklab(sage).tail<2>().norm(), 0.08, 0.01);
}

TEST(Palette, simulated_readers_confuse_what_they_must) {
  const Pixel grey = {128, 128, 128};
  for (const Vision vision : {Vision::Protanopia, Vision::Deuteranopia, Vision::Tritanopia}) {
    EXPECT_LT((to_oklab(seen_by(vision, grey)) - to_oklab(grey)).norm(), 0.01);
  }
  // A red and a green of one lightness: far apart for most, near for a deuteranope.
  const Pixel red = from_oklch(0.65, 0.12, 30), green = from_oklch(0.65, 0.12, 140);
  const auto apart = [&](Vision vision) {
    return (to_oklab(seen_by(vision, red)) - to_oklab(seen_by(vision, green))).norm();
  };
  EXPECT_LT(apart(Vision::Deuteranopia), 0.5 * apart(Vision::Normal));
  EXPECT_LE(contrast(red, green), apart(Vision::Deuteranopia) + 1e-12);
}

TEST(Palette, touching_segments_of_the_room_differ_for_every_reader_and_in_grey) {
  const ToyScene toy = toy_room();
  const SceneData scene = scene_data(toy.scene, toy.cloud);
  const SceneColors colors = choose_colors(scene);
  ASSERT_EQ(colors.segments.size(), 10U);
  std::set<std::pair<std::uint32_t, std::uint32_t>> touching;
  for (const Edge& edge : toy.scene.edges) {
    const std::uint32_t a = toy.scene.segments.patch_label[edge.first];
    const std::uint32_t b = toy.scene.segments.patch_label[edge.second];
    if (a != b) touching.insert({a, b});
  }
  EXPECT_GT(touching.size(), 8U);
  for (const auto& [a, b] : touching) {
    EXPECT_GT(contrast(colors.segments[a - 1], colors.segments[b - 1]), 0.06) << a << ' ' << b;
  }
  std::set<Pixel> different(colors.segments.begin(), colors.segments.end());
  EXPECT_EQ(different.size(), 10U);
  EXPECT_GT(std::abs(luma(kEdgeOn) - luma(kEdgeOff)), 30);
}

TEST(Palette, large_planes_are_calm_and_objects_vivid) {
  const auto chroma = [](const Pixel& p) { return to_oklab(p).tail<2>().norm(); };
  for (const Pixel& p : calm_colors()) {
    EXPECT_LT(chroma(p), 0.09);
    EXPECT_GT(to_oklab(p).x(), 0.68);
  }
  for (const Pixel& p : vivid_colors()) EXPECT_GT(chroma(p), 0.09);
}

TEST(Palette, neighbours_never_share_a_color_while_there_are_enough) {
  const std::vector<Pixel> vivid = vivid_colors();
  Neighbours ring;
  for (std::uint32_t i = 0; i < 40; ++i)
    for (std::uint32_t k = 1; k <= 4; ++k) ring.emplace_back(i, (i + k) % 40);
  const std::vector<Pixel> colors = assign_colors(std::vector<std::size_t>(40, 0), {vivid}, ring);
  for (const auto& [a, b] : ring) EXPECT_NE(colors[a], colors[b]);
}

/// A map of 300 countries: cells of random seeds, which touch as cells of a grid do.
Neighbours random_map(std::uint64_t seed, std::uint32_t count) {
  std::mt19937_64 random(seed);
  std::vector<std::array<int, 2>> seeds;
  for (std::uint32_t i = 0; i < count; ++i)
    seeds.push_back({static_cast<int>(random() % 120), static_cast<int>(random() % 120)});
  const auto owner = [&](int x, int y) {
    std::uint32_t best = 0;
    const auto distance = [&](std::uint32_t i) {
      return std::hypot(seeds[i][0] - x, seeds[i][1] - y);
    };
    for (std::uint32_t i = 1; i < count; ++i)
      if (distance(i) < distance(best)) best = i;
    return best;
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> row(120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      const std::uint32_t here = owner(x, y);
      const auto at = static_cast<std::size_t>(x);
      if (x > 0 && row[at - 1] != here) pairs.insert(std::minmax(row[at - 1], here));
      if (y > 0 && row[at] != here) pairs.insert(std::minmax(row[at], here));
      row[at] = here;
    }
  }
  return {pairs.begin(), pairs.end()};
}

TEST(Palette, neighbours_differ_for_every_reader_on_maps_of_many_segments) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Neighbours touching = random_map(seed, 300);
    EXPECT_GT(touching.size(), 700U);
    std::vector<std::size_t> groups(300, 1);  // objects, and a wall or floor among ten
    for (std::size_t i = 0; i < groups.size(); i += 10) groups[i] = 0;
    const auto least = least_differences(
        assign_colors(groups, {calm_colors(), vivid_colors()}, touching), touching);
    // Oklab: 0.02 is just seen. In the order of Vision.
    EXPECT_GT(least[0], 0.10) << "normal, map " << seed;
    for (std::size_t v = 1; v < 5; ++v) EXPECT_GT(least[v], 0.05) << v << ", map " << seed;
  }
}

TEST(Palette, colors_that_are_given_are_kept_and_others_keep_clear_of_them) {
  const std::vector<Pixel> vivid = vivid_colors();
  const std::vector<std::optional<Pixel>> given = {std::nullopt, vivid[3], std::nullopt,
                                                   Pixel{1, 2, 3}};
  const Neighbours chain = {{0, 1}, {1, 2}, {2, 3}};
  const auto colors = assign_colors({0, 0, 0, 0}, {vivid}, chain, given);
  EXPECT_EQ(colors[1], vivid[3]);
  EXPECT_NE(colors[3], (Pixel{1, 2, 3})) << "is no candidate";
  EXPECT_GT(contrast(colors[0], colors[1]), 0.06);
  EXPECT_GT(contrast(colors[1], colors[2]), 0.06);
}

TEST(Image, is_shrunk_to_means_of_blocks) {
  Image image = filled(4, 2, {10, 20, 30});
  image.rgb[0] = 20;           // in the left block
  image.rgb[3 * 5] = 14;       // too: (20 + 10 + 10 + 14) / 4 = 13.5
  image.rgb[3 * 7 + 2] = 255;  // in the right block: (30 * 3 + 255) / 4 = 86.25
  const Image small = downsample(image, 2);
  EXPECT_EQ(small.rgb, (std::vector<std::uint8_t>{14, 20, 30, 10, 20, 86}));
  EXPECT_EQ(downsample(image, 1), image);
}

TEST(Image, knows_when_it_is_uniform) {
  Image image = filled(5, 4, {1, 2, 3});
  EXPECT_TRUE(is_uniform(image, 0, 4));
  image.rgb[3 * 5 + 1] = 0;  // second row
  EXPECT_FALSE(is_uniform(image, 0, 4));
  EXPECT_TRUE(is_uniform(image, 2, 4));
}

TEST(Image, survives_a_png_and_is_pasted_where_said) {
  Image canvas = filled(7, 5, {255, 255, 255});
  paste(canvas, filled(2, 3, {9, 8, 7}), 4, 1);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 7; ++x) {
      const bool inside = x >= 4 && x < 6 && y >= 1 && y < 4;
      EXPECT_EQ(canvas.rgb[static_cast<std::size_t>(3 * (y * 7 + x))], inside ? 9 : 255);
    }
  }
  const TemporaryFolder folder;
  write_png(canvas, folder / "a.png");
  EXPECT_EQ(read_png(folder / "a.png"), canvas);
  testing::write_bytes(folder / "b.png", "no picture");
  EXPECT_THROW(read_png(folder / "b.png"), Error);
  EXPECT_THROW(read_png(folder / "c.png"), Error);
}

}  // namespace
}  // namespace planescope::draw
