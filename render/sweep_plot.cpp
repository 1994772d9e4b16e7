// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/sweep_plot.hpp"

#include <charconv>

#include "chart.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"

namespace planescope {
namespace {

using draw::Chart;
using draw::Pixel;

constexpr Pixel kBlue = {31, 88, 168}, kAmber = {217, 119, 6}, kCrimson = {190, 18, 60};
constexpr Pixel kGreen = {30, 130, 90}, kViolet = {116, 44, 170};

template <class Value>
std::vector<double> column(const std::vector<SweepRow>& rows, const Value& value) {
  std::vector<double> all;
  all.reserve(rows.size());
  for (const SweepRow& row : rows) all.push_back(static_cast<double>(value(row)));
  return all;
}

draw::ChartAxis axis_of(const SweepRange& range) {
  draw::ChartAxis axis;
  axis.title = range.option;
  for (const OptionInfo& info : option_table()) {
    const bool measured = info.unit == "m" || info.unit == "deg" || info.unit == "m^2";
    if (info.name == range.option && measured) axis.title += " [" + info.unit + "]";
  }
  bool numbers = true;
  for (const std::string& text : range.values) {
    double value = 0;
    const char* end = text.data() + text.size();
    numbers &= std::from_chars(text.data(), end, value).ptr == end;
    axis.values.push_back(value);
  }
  if (numbers) return axis;
  axis.labels = range.values;
  for (std::size_t i = 0; i < axis.values.size(); ++i) axis.values[i] = static_cast<double>(i);
  return axis;
}

Chart edge_chart(const std::vector<SweepRow>& rows) {
  if (rows.front().switched_on)
    return {"edges flipped",
            {{"to ON", column(rows, [](const SweepRow& r) { return r.switched_on.value_or(0); }),
              kBlue},
             {"to OFF", column(rows, [](const SweepRow& r) { return r.switched_off.value_or(0); }),
              kAmber}}};
  return {"number",
          {{"patches", column(rows, [](const SweepRow& r) { return r.patches; }), kBlue},
           {"OFF edges", column(rows, [](const SweepRow& r) { return r.edges_off; }), kAmber}}};
}

Chart score_chart(const std::vector<SweepRow>& rows) {
  Chart chart{"score",
              {{"agreement with the stored run",
                column(rows, [](const SweepRow& r) { return r.agreement; }),
                {120, 124, 130}}},
              true};
  if (!rows.front().scores) return chart;
  const auto add = [&](const char* name, double LabelScores::*score, const Pixel& color) {
    chart.curves.push_back(
        {name, column(rows, [&](const SweepRow& r) { return (*r.scores).*score; }), color});
  };
  add("weighted overlap WO", &LabelScores::weighted_overlap, kGreen);
  add("overlap UO", &LabelScores::overlap, kBlue);
  add("over-segmentation", &LabelScores::over_segmentation, kViolet);
  add("under-segmentation", &LabelScores::under_segmentation, kCrimson);
  return chart;
}

}  // namespace

void plot_sweep(const SweepRange& range, const std::vector<SweepRow>& rows,
                const SweepPlotOptions& options, const std::filesystem::path& png) {
  if (rows.empty()) throw Error(Error::Kind::Usage, "sweep: there is no row to plot");
  if (options.size[0] < 320 || options.size[1] < 320 || options.size[0] > 8192 ||
      options.size[1] > 8192)
    throw Error(Error::Kind::Usage, "plot size " + std::to_string(options.size[0]) + "x" +
                                        std::to_string(options.size[1]) +
                                        ": each side must be 320 to 8192 pixels");
  const Chart counts{
      "number",
      {{"segments", column(rows, [](const SweepRow& r) { return r.segments; }), kBlue},
       {"planes", column(rows, [](const SweepRow& r) { return r.planes; }), kAmber}}};
  draw::PngNotes notes;
  notes.texts.emplace_back("Software", "planescope " PLANESCOPE_VERSION ", VTK " + vtk_version());
  draw::write_png(draw::draw_charts({counts, edge_chart(rows), score_chart(rows)}, axis_of(range),
                                    options.title, options.size),
                  png, notes);
}

}  // namespace planescope
