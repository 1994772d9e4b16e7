// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "chart.hpp"
#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "planescope/sweep_plot.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;

/// The lowest and highest row with pixels of this colour, or (height, -1).
std::array<int, 2> rows_of(const draw::Image& image, const draw::Pixel& color) {
  std::array<int, 2> rows = {image.height, -1};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width * 6 / 10; ++x) {  // left of the legend
      const std::uint8_t* p = &image.rgb[static_cast<std::size_t>(3 * (y * image.width + x))];
      if (!std::equal(color.begin(), color.end(), p)) continue;
      rows = {std::min(rows[0], y), std::max(rows[1], y)};
    }
  return rows;
}

constexpr draw::Pixel kRed = {200, 0, 0}, kBlue = {0, 0, 200};

TEST(RenderSweep, CurvesGoWhereTheirValuesSay) {
  const draw::ChartAxis axis{"x", {1, 2, 3, 4}, {}};
  const draw::Image image =
      draw::draw_charts({{"y", {{"level", {1, 1, 1, 1}, kRed}, {"rising", {0, 3, 6, 9}, kBlue}}}},
                        axis, "t", {600, 400});
  const auto red = rows_of(image, kRed), blue = rows_of(image, kBlue);
  ASSERT_GE(red[1], 0);
  ASSERT_GE(blue[1], 0);
  // Pixel rows count downwards: the level curve lies at a ninth of the rising one's height.
  const double height = blue[1] - blue[0];
  const double level = (red[0] + red[1]) / 2.0;
  EXPECT_NEAR((blue[1] - level) / height, 1.0 / 9, 0.03);
}

TEST(RenderSweep, PlotsNumbersAndNames) {
  const TemporaryFolder folder;
  SweepRow row;
  row.segments = 4;
  row.planes = 2;
  row.switched_on = row.switched_off = 1;
  row.agreement = 0.9;
  std::vector<SweepRow> rows(2, row);
  const SweepPlotOptions options{.size = {480, 400}, .title = "scene"};
  plot_sweep({"planes.solver", {"lsa_tr", "lsa_tr+tabu"}}, rows, options, folder / "names.png");
  plot_sweep({"planes.sigma", {"0.1", "0.2"}}, rows, options, folder / "numbers.png");
  plot_sweep({"planes.sigma", {"0.1", "0.2"}}, rows, options, folder / "again.png");
  EXPECT_EQ(testing::read_bytes(folder / "numbers.png"), testing::read_bytes(folder / "again.png"));
  EXPECT_NE(testing::read_bytes(folder / "numbers.png"), testing::read_bytes(folder / "names.png"));
  EXPECT_EQ(draw::read_png(folder / "names.png").width, 480);
  rows[0].switched_on.reset();  // other patches
  rows[0].scores.emplace();
  rows[1].scores.emplace();
  EXPECT_NO_THROW(
      plot_sweep({"patches.weight_normal", {"1", "2"}}, rows, options, folder / "patches.png"));
  EXPECT_THROW(plot_sweep({"planes.sigma", {}}, {}, options, folder / "a.png"), Error);
  EXPECT_THROW(plot_sweep({"planes.sigma", {"1", "2"}}, rows, {.size = {100, 100}, .title = ""},
                          folder / "a.png"),
               Error);
}

}  // namespace
}  // namespace planescope
