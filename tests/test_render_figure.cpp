// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "caption.hpp"
#include "color_matching.hpp"
#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "planescope/figure.hpp"
#include "test_render_scene.hpp"

/// \file The figure of several panels: one colour an object, and where everything stands.
namespace planescope {
namespace {

using draw::Image;
using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;
using Labels = std::vector<std::uint32_t>;

/// Objects of the labels, point by point; -1 for label 0.
std::vector<int> objects(const draw::MatchedLabels& matched, std::size_t which,
                         const Labels& labels) {
  std::vector<int> found;
  for (const std::uint32_t label : labels)
    found.push_back(label == 0 ? -1 : static_cast<int>(matched.object[which][label]));
  return found;
}

TEST(MatchLabels, OtherNamesAreTheSameObjects) {
  const Labels a = {1, 1, 1, 2, 2, 0}, b = {9, 9, 9, 4, 4, 0};
  const auto matched = draw::match_labels({a, b});
  EXPECT_EQ(objects(matched, 0, a), objects(matched, 1, b));
  EXPECT_EQ(matched.points, (std::vector<std::size_t>{3, 2}));
}

TEST(MatchLabels, OneToOneTheLargestOverlapFirst) {
  // Object 0 has four points; b cuts it into three and one: the larger part keeps its colour.
  const Labels a = {1, 1, 1, 1, 2, 2}, b = {5, 7, 7, 7, 6, 6};
  const auto matched = draw::match_labels({a, b});
  EXPECT_EQ(objects(matched, 1, b), (std::vector<int>{2, 0, 0, 0, 1, 1}));
  // c merges both: overlap 4/6 with the one, 2/6 with the other.
  const Labels c(6, 3);
  EXPECT_EQ(objects(draw::match_labels({a, c}), 1, c), std::vector<int>(6, 0));
}

TEST(MatchLabels, WhatTheTruthLacksIsMatchedAmongTheOthers) {
  const Labels truth = {1, 1, 0, 0, 0}, a = {4, 4, 2, 2, 2}, b = {1, 1, 8, 8, 8};
  const auto matched = draw::match_labels({truth, a, b});
  EXPECT_EQ(objects(matched, 1, a), (std::vector<int>{0, 0, 1, 1, 1}));
  EXPECT_EQ(objects(matched, 2, b), objects(matched, 1, a));
}

TEST(MatchLabels, ASliverIsNotTheObjectThatItTouches) {
  Labels a(100, 1), b(100, 0);
  b[0] = 1;
  EXPECT_EQ(draw::match_labels({a, b}).object[1][1], 1U) << "overlap 1 %";
}

TEST(ColorObjects, NeighboursOfAnyPanelDiffer) {
  const Labels a = {1, 1, 2, 2}, b = {1, 2, 2, 2};
  const auto matched = draw::match_labels({a, b});
  const std::vector<std::int32_t> patches = {0, 1, 2, 3};
  const auto touching =
      draw::touching_objects({a, b}, matched, patches, 4, {{0, 1}, {1, 2}, {2, 3}});
  EXPECT_EQ(touching, (draw::Neighbours{{0, 1}}));
  const auto colors = draw::color_objects(matched, {true, true}, touching);
  ASSERT_EQ(colors.size(), 2U);
  EXPECT_GT(draw::contrast(colors[0], colors[1]), 0.02);
}

TEST(ColorObjects, WhatLiesOnPlanesIsCalmInAllPanels) {
  // Object 0: points 0 to 3, three of them on a plane; object 1: points 4 and 5, one.
  const Labels a = {1, 1, 1, 1, 2, 2}, b = {2, 2, 2, 3, 3, 3};
  const auto matched = draw::match_labels({a, b});
  const std::vector<std::int32_t> planes = {0, 0, 0, kNone, 0, kNone};
  EXPECT_EQ(draw::objects_on_planes({a, b}, matched, planes), (std::vector<bool>{true, false}));
  const std::vector<std::int32_t> none(6, kNone);
  EXPECT_EQ(draw::objects_on_planes({a, b}, matched, none), (std::vector<bool>{true, true}));
  const auto colors = draw::color_objects(matched, {true, false}, {{0, 1}});
  EXPECT_LT(draw::to_oklab(colors[0]).tail<2>().norm(), 0.10);
  EXPECT_GT(draw::to_oklab(colors[1]).tail<2>().norm(), 0.10);
}

TEST(Caption, ResolutionIsWhatAnyProgramWritesFor300Dpi) {
  const std::string png =
      draw::encode_png(draw::filled(4, 3, {1, 2, 3}), {.texts = {}, .dpi = 300});
  const std::string chunk("\0\0\0\x09pHYs\0\0\x2E\x23\0\0\x2E\x23\x01\x78\xA5\x3F\x76", 21);
  EXPECT_EQ(png.find(chunk), 33U);
  const TemporaryFolder folder;
  testing::write_bytes(folder / "a.png", png);
  EXPECT_EQ(draw::read_png(folder / "a.png"), draw::filled(4, 3, {1, 2, 3}));
}

TEST(ColorObjects, TheLargestAllDiffer) {
  draw::MatchedLabels matched;
  matched.points = {900, 500, 100, 90, 80, 70, 60, 50, 40, 30};
  const auto colors = draw::color_objects(matched, std::vector<bool>(10, false), {});
  for (std::size_t i = 0; i < colors.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(colors[i], colors[j]) << i << " and " << j;
}

/// Rows of a black text on white that hold ink.
int inked_rows(const Image& image) {
  int rows = 0;
  const auto row = static_cast<std::ptrdiff_t>(image.width) * 3;
  for (auto at = image.rgb.begin(); at != image.rgb.end(); at += row)
    rows += *std::min_element(at, at + row) < 128 ? 1 : 0;
  return rows;
}

TEST(Caption, IsAsHighInPrintAsItsPoints) {
  const draw::Pixel black = {0, 0, 0}, white = {255, 255, 255};
  // 12 points at 300 dpi are 50 pixels; capitals are about 0.72 of the font.
  EXPECT_NEAR(inked_rows(draw::draw_text("H", 12, 300, black, white)), 36, 3);
  EXPECT_NEAR(inked_rows(draw::draw_text("H", 12, 150, black, white)), 18, 2);
  EXPECT_NEAR(inked_rows(draw::draw_text("H", 6, 300, black, white)), 18, 2);
}

Image crop(const Image& image, int x, int y, int width, int height) {
  Image piece{width, height, {}};
  for (int row = y; row < y + height; ++row) {
    const auto from = image.rgb.begin() + 3 * (row * image.width + x);
    piece.rgb.insert(piece.rgb.end(), from, from + 3 * width);
  }
  return piece;
}

/// Four panels of 240 x 180 at 150 dpi: gaps of 9 pixels.
Image figure(const ToyScene& toy, const std::vector<FigurePanel>& panels, std::string* bytes) {
  FigureOptions options;
  options.dpi = 150;
  options.width_mm = (2 * 240 + 9) / 150.0 * 25.4;
  const TemporaryFolder folder;
  render_figure(toy.scene, toy.cloud, panels, options, folder / "f.png");
  *bytes = testing::read_bytes(folder / "f.png");
  return draw::read_png(folder / "f.png");
}

TEST(Figure, TheSameObjectsLookTheSameInEveryPanel) {
  const ToyScene toy = toy_room(0.03F);
  const Labels& truth = toy.scene.point_label;
  Labels renamed = truth, merged = truth;
  for (std::uint32_t& label : renamed) label = 3 * (11 - label);
  for (std::uint32_t& label : merged)
    if (label == 8) label = 1;  // a box becomes floor
  std::string bytes, again;
  const std::vector<FigurePanel> panels = {{"Scene", "", {}},
                                           {"Renamed", "", renamed},
                                           {"Merged", "", merged},
                                           {"Truth", "", truth, true}};
  const Image picture = figure(toy, panels, &bytes);
  figure(toy, panels, &again);
  EXPECT_EQ(bytes, again);
  const int caption = (picture.height - 9 - 2 * 180) / 2, below = 180 + caption + 9;
  EXPECT_GT(caption, 15);
  EXPECT_EQ(picture.width, 489);
  const Image renamed_panel = crop(picture, 249, 0, 240, 180);
  const Image merged_panel = crop(picture, 0, below, 240, 180);
  const Image truth_panel = crop(picture, 249, below, 240, 180);
  EXPECT_EQ(renamed_panel, truth_panel);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < truth_panel.rgb.size(); i += 3)
    differ += std::equal(truth_panel.rgb.begin() + static_cast<std::ptrdiff_t>(i),
                         truth_panel.rgb.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                         merged_panel.rgb.begin() + static_cast<std::ptrdiff_t>(i))
                  ? 0
                  : 1;
  EXPECT_GT(differ, 100U) << "the box has the floor's colour";
  EXPECT_LT(differ, 240U * 180 / 8) << "and nothing else has changed";
}

TEST(Figure, RefusesWhatItCannotLayOut) {
  const ToyScene toy = toy_room(0.1F);
  const auto kind = [&](const std::vector<FigurePanel>& panels, FigureOptions options) {
    const TemporaryFolder folder;
    try {
      render_figure(toy.scene, toy.cloud, panels, options, folder / "f.png");
    } catch (const Error& error) {
      EXPECT_FALSE(std::filesystem::exists(folder / "f.png"));
      return error.kind();
    }
    return Error::Kind::Internal;
  };
  FigureOptions tiny, coarse;
  tiny.size = {60, 40};
  coarse.dpi = 10;
  EXPECT_EQ(kind({}, {}), Error::Kind::Usage);
  EXPECT_EQ(kind({{"Scene", "", {}}}, tiny), Error::Kind::Usage);
  EXPECT_EQ(kind({{"Scene", "", {}}}, coarse), Error::Kind::Usage);
  EXPECT_EQ(kind({{"Few", "", {1, 2}}}, {}), Error::Kind::Usage);
}

}  // namespace
}  // namespace planescope
