// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

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
