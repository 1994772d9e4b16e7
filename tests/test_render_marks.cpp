// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "annotation.hpp"
#include "camera.hpp"
#include "label_places.hpp"
#include "marks.hpp"
#include "point_layer.hpp"
#include "scene_data.hpp"
#include "test_render_scene.hpp"
#include "viewpoint.hpp"

/// \file Numbers of segments and legends: where they stand and what they say.
namespace planescope::draw {
namespace {

using testing::toy_room;
using testing::ToyScene;

TEST(LabelPlaces, ClearanceIsTheDistanceToAnotherLabelByBruteForce) {
  std::mt19937_64 random(1);
  LabelMap map{23, 17, {}};
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      map.labels.push_back(static_cast<std::uint32_t>(x / 6 + y / 7) % 3 +
                           (random() % 40 == 0 ? 1 : 0));
  const std::vector<int> room = clearance(map);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      int least = std::min({x + 1, y + 1, map.width - x, map.height - y});
      for (int v = 0; v < map.height; ++v)
        for (int u = 0; u < map.width; ++u)
          if (map.at(u, v) != map.at(x, y))
            least = std::min(least, std::max(std::abs(u - x), std::abs(v - y)));
      EXPECT_EQ(room[static_cast<std::size_t>(y * map.width + x)], least) << x << ' ' << y;
    }
  }
}

TEST(LabelPlaces, AreOnWhatTheyNameAndNearItsCentroid) {
  // Segment 1 is all but a block of segment 2 in its middle and a corner of segment 3.
  LabelMap map{21, 21, std::vector<std::uint32_t>(21 * 21, 1)};
  for (int y = 0; y < 21; ++y) {
    for (int x = 0; x < 21; ++x) {
      const auto at = static_cast<std::size_t>(21 * y + x);
      if (std::max(std::abs(x - 10), std::abs(y - 10)) <= 3) map.labels[at] = 2;
      if (x < 1 && y < 1) map.labels[at] = 3;
    }
  }
  const auto places = label_places(
      map, 4,
      [](std::uint32_t) {
        return std::array{10, 10};
      },
      [](std::uint32_t) { return 2; }, 2);
  ASSERT_TRUE(places[0]);
  const auto [x, y] = *places[0];
  EXPECT_EQ(map.at(x, y), 1U);
  // Two cells of room beyond the block's three, straight aside.
  EXPECT_EQ(std::abs(x - 10) + std::abs(y - 10), 5);
  EXPECT_EQ(*places[1], (std::array{10, 10}));
  EXPECT_FALSE(places[2]) << "one cell is too small";
  EXPECT_FALSE(places[3]) << "is not there";
}

TEST(Marks, StandOnTheirSegmentsInTheRoom) {
  ToyScene toy = toy_room();
  // Centroids, as segment() gives them; that of the floor lies under the table.
  std::vector<Eigen::Vector3f> sums(toy.scene.segments.segments.size(), Eigen::Vector3f::Zero());
  std::vector<float> counts(sums.size(), 0);
  for (std::size_t i = 0; i < toy.cloud.size(); ++i) {
    sums[toy.scene.point_label[i] - 1] += toy.cloud.positions[i];
    counts[toy.scene.point_label[i] - 1] += 1;
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    toy.scene.segments.segments[k].centroid = sums[k] / counts[k];
  const SceneData scene = scene_data(toy.scene, toy.cloud);
  const SceneFrame frame = scene_frame(scene, {});
  const double aspect = 4.0 / 3;
  const Camera camera = choose_view(View::Top, scene, frame).fit(toy.cloud.positions, aspect, {});
  const Layout layout(800, 600, {});
  const auto marks = segment_marks(scene, Cutaway(), camera, layout);
  EXPECT_GE(marks.size(), 6U);
  for (const Mark& mark : marks) {
    // The nearest point to the eye within two pixels of the place is of that segment.
    double nearest = 1e9;
    std::uint32_t label = 0;
    for (std::size_t i = 0; i < toy.cloud.size(); ++i) {
      const Eigen::Vector3d seen = project(camera, aspect, toy.cloud.positions[i].cast<double>());
      const double off =
          std::hypot((seen.x() - mark.place[0]) * 400, (seen.y() - mark.place[1]) * 300);
      if (off > 6 || seen.z() > nearest) continue;
      nearest = seen.z();
      label = toy.scene.point_label[i];
    }
    EXPECT_EQ(std::to_string(label), mark.text);
  }
}

TEST(Legend, OfASceneWithoutColorsSaysTheHeights) {
  ToyScene toy = toy_room();
  SceneData scene = scene_data(toy.scene, toy.cloud);
  SceneColors colors = choose_colors(scene);
  colors.heights = {0, 2.4F};
  EXPECT_TRUE(color_legend(scene, colors, point_colors(Layer::Scene, ColorBy::Layers), Layer::Scene)
                  .empty());
  scene.result.has_colors = false;
  const auto legend =
      color_legend(scene, colors, point_colors(Layer::Scene, ColorBy::Layers), Layer::Scene);
  ASSERT_EQ(legend.size(), 3U);
  EXPECT_EQ(legend[2].text, "2.4 m");
  EXPECT_TRUE(color_legend(scene, colors, point_colors(Layer::Graph, ColorBy::Layers), Layer::Graph)
                  .empty())
      << "points under a graph are grey";
  const auto planes = color_legend(scene, colors, point_colors(Layer::Planes, ColorBy::Layers),
                                   Layer::Planes | Layer::Graph);
  ASSERT_EQ(planes.size(), 6U);
  EXPECT_EQ(planes[0].text, "plane 0: 12.00 m\u00b2");
}

TEST(Legend, ThatIsTooLongSaysHowManyAreLeftOut) {
  Annotation words;
  for (int i = 0; i < 30; ++i)
    words.legend.push_back({LegendEntry::Swatch::Box, {}, std::to_string(i) + ": 1.00 m\u00b2"});
  shorten_legend(words, 800, 600);
  const std::size_t left = words.legend.size() - 1;
  EXPECT_EQ(words.legend.back().text, "and " + std::to_string(30 - left) + " more");
  EXPECT_EQ(words.legend.back().swatch, LegendEntry::Swatch::None);
}

}  // namespace
}  // namespace planescope::draw
