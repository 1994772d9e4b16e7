// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "close_up.hpp"
#include "fixtures.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"
#include "planescope/synthesize.hpp"
#include "solids.hpp"

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace planescope {
namespace {

using testing::TemporaryFolder;

const StoredScene& room() {
  static const StoredScene kRoom = [] {
    StoredScene stored;
    SynthesisOptions options;
    options.random_seed = 5;
    options.points = 40'000;
    stored.cloud = synthesize(options).cloud;
    stored.scene = segment(stored.cloud, Options::automatic(stored.cloud));
    return stored;
  }();
  return kRoom;
}

/// Pixels of about this hue: the lamp darkens colours, and does not change their mixture.
std::size_t count_like(const draw::Image& image, const draw::Pixel& color) {
  const auto mixture = [](double r, double g, double b) {
    return Eigen::Vector3d(r, g, b).normalized();
  };
  const Eigen::Vector3d wanted = mixture(color[0], color[1], color[2]);
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
    const Eigen::Vector3d rgb(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
    if (rgb.norm() > 60 && rgb.normalized().dot(wanted) > 0.9995) ++count;
  }
  return count;
}

TEST(RenderCloseUp, AnEdgeShowsBothPatches) {
  const TemporaryFolder folder;
  EdgeExplainer explain(room().scene);
  int drawn = 0;
  for (const EdgeRule rule : {EdgeRule::Concave, EdgeRule::Convex, EdgeRule::PlaneBoundary}) {
    const auto found = std::ranges::find(room().scene.edges, rule, &Edge::rule);
    ASSERT_NE(found, room().scene.edges.end());
    const auto x = explain(static_cast<std::size_t>(found - room().scene.edges.begin()));
    const auto png = folder / (std::string(name(rule)) + ".png");
    draw_close_up(room(), x, {.size = {800, 500}, .supersample = 1}, png);
    const draw::Image image = draw::read_png(png);
    EXPECT_EQ(image.width, 800);
    EXPECT_EQ(image.height, 500);
    EXPECT_GT(count_like(image, draw::kFirstPatch), 300u) << name(rule);
    EXPECT_GT(count_like(image, draw::kSecondPatch), 300u) << name(rule);
    ++drawn;
  }
  EXPECT_EQ(drawn, 3);
}

TEST(RenderCloseUp, SameFindingSameBytes) {
  const TemporaryFolder folder;
  EdgeExplainer explain(room().scene);
  const auto x = explain(0, Flips::Skip);
  const CloseUpOptions options{.size = {480, 320}, .supersample = 1};
  draw_close_up(room(), x, options, folder / "a.png");
  draw_close_up(room(), x, options, folder / "b.png");
  EXPECT_EQ(testing::read_bytes(folder / "a.png"), testing::read_bytes(folder / "b.png"));
}

TEST(RenderCloseUp, ChainsPlanesAndGapsAreDrawn) {
  const TemporaryFolder folder;
  const CloseUpOptions options{.size = {640, 400}, .supersample = 1};
  const Chain chain = chain_between(room().scene, 0, 900);
  draw_close_up(room(), chain, options, folder / "chain.png");
  EXPECT_GT(count_like(draw::read_png(folder / "chain.png"), draw::kEdgeOn), 50u);
  PlaneExplainer planes(room().scene);
  draw_close_up(room(), planes.plane(0, {}, Flips::Skip), options, folder / "plane.png");
  draw::Pixel seen{};  // the plane's patches through its translucent sheet
  for (std::size_t c = 0; c < 3; ++c)
    seen[c] = static_cast<std::uint8_t>(0.78 * draw::lighten(draw::kFirstPatch, 0.4)[c] +
                                        0.22 * draw::kFirstPatch[c]);
  EXPECT_GT(count_like(draw::read_png(folder / "plane.png"), seen), 2000u);
  const auto& patches = room().scene.graph.patches;
  std::size_t p = 0;
  while (room().scene.patch_plane[p].plane != kNone) ++p;
  draw_close_up(room(), planes.missing(patches[p].centroid, 0, Flips::Skip), options,
                folder / "missing.png");
  EXPECT_GT(count_like(draw::read_png(folder / "missing.png"), draw::kWrong), 50u);
}

TEST(RenderCloseUp, SmallPicturesAreRefused) {
  EdgeExplainer explain(room().scene);
  const TemporaryFolder folder;
  EXPECT_THROW(
      draw_close_up(room(), explain(0, Flips::Skip), {.size = {100, 100}}, folder / "a.png"),
      Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

// The panel breaks long lines and never writes over its rim.
TEST(RenderCloseUp, PanelKeepsWithinItsWidth) {
  const std::string words = "a line that is much too long for a panel of this width and goes on";
  const auto inked_rows = [](const std::string& text) {
    const draw::Image image =
        draw::draw_panel({{text, draw::PanelLine::Style::Plain, {}}}, 200, 300, 1);
    int rows = 0;
    for (int y = 0; y < image.height; ++y) {
      const auto dark = [&](int x) {
        return image.rgb[static_cast<std::size_t>(3 * (y * image.width + x))] < 128;
      };
      bool any = false;
      for (int x = 0; x < image.width; ++x) any |= dark(x);
      EXPECT_FALSE(dark(image.width - 1));
      rows += any ? 1 : 0;
    }
    return rows;
  };
  EXPECT_GT(inked_rows("a line"), 3);
  EXPECT_GE(inked_rows(words), 2 * inked_rows("a line"));
}

// All corners of a tube lie at its radius from its axis.
TEST(RenderCloseUp, SolidsHaveTheirSize) {
  draw::Solids solids;
  solids.add_tube({1, 2, 3}, {1, 2, 5}, 0.1, draw::kInk);
  solids.add_ball({9, 9, 9}, 0, draw::kInk);
  const auto actor = solids.actor();
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  ASSERT_NE(data, nullptr);
  std::array<double, 6> bounds{};
  data->GetBounds(bounds.data());
  EXPECT_NEAR(bounds[4], 3, 1e-6);
  for (vtkIdType i = 0; i < 24; ++i) {
    std::array<double, 3> p{};
    data->GetPoint(i, p.data());
    EXPECT_NEAR(std::hypot(p[0] - 1, p[1] - 2), 0.1, 1e-6);
  }
}

}  // namespace
}  // namespace planescope
