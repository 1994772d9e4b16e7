// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "chart.hpp"

#include <algorithm>
#include <cmath>

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include "overlay.hpp"
#include "palette.hpp"
#include "vtk_arrays.hpp"
#include "window.hpp"

namespace planescope::draw {
namespace {

constexpr int kScale = 2;  // antialiasing: drawn twice as large

vtkSmartPointer<vtkTable> table(const Chart& chart, const ChartAxis& axis) {
  auto data = vtkSmartPointer<vtkTable>::New();
  data->AddColumn(make_column<vtkDoubleArray>(axis.title.c_str(), axis.values.size(),
                                              [&](std::size_t i) { return axis.values[i]; }));
  for (const Curve& curve : chart.curves)
    data->AddColumn(make_column<vtkDoubleArray>(curve.name.c_str(), curve.values.size(),
                                                [&](std::size_t i) { return curve.values[i]; }));
  return data;
}

void style_text(vtkTextProperty& text, double size) {
  text.SetFontFamilyToArial();
  text.SetFontSize(static_cast<int>(size));
  text.BoldOff();
  text.SetColor(kInk[0] / 255.0, kInk[1] / 255.0, kInk[2] / 255.0);
}

void style_axis(vtkAxis& axis, const std::string& title, double font) {
  axis.SetTitle(title);
  style_text(*axis.GetTitleProperties(), font);
  style_text(*axis.GetLabelProperties(), 0.85 * font);
  axis.GetPen()->SetWidth(static_cast<float>(font / 12));
  axis.GetGridPen()->SetColor(228, 230, 234);
  axis.GetGridPen()->SetWidth(static_cast<float>(font / 16));
}

/// The x axis: custom labels where values are names, else round numbers with a margin.
void set_x(vtkAxis& axis, const ChartAxis& x) {
  const auto [low, high] = std::ranges::minmax(x.values);
  const double margin = high > low ? 0.03 * (high - low) : 0.5;
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(low - margin, high + margin);
  if (x.labels.empty()) return;
  vtkNew<vtkStringArray> names;
  for (const std::string& label : x.labels) names->InsertNextValue(label);
  axis.SetCustomTickPositions(
      make_column<vtkDoubleArray>("tick", x.values.size(),
                                  [&](std::size_t i) { return x.values[i]; }),
      names);
}

void set_y(vtkAxis& axis, const Chart& chart) {
  double high = 1;
  for (const Curve& curve : chart.curves)
    for (const double value : curve.values) high = std::max(high, value);
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(0, chart.share ? 1.02 : 1.08 * high);
}

vtkSmartPointer<vtkChartXY> make_chart(const Chart& chart, const ChartAxis& axis, double font,
                                       bool last) {
  auto xy = vtkSmartPointer<vtkChartXY>::New();
  xy->SetAutoSize(false);
  xy->SetShowLegend(false);
  const auto data = table(chart, axis);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    auto* line = vtkPlotLine::SafeDownCast(xy->AddPlot(vtkChart::LINE));
    const Pixel& color = chart.curves[i].color;
    line->SetInputData(data, 0, static_cast<vtkIdType>(i) + 1);
    line->SetColor(color[0], color[1], color[2], 255);
    line->SetWidth(static_cast<float>(font / 6));
    line->SetMarkerStyle(i == 0 ? vtkPlotPoints::CIRCLE : vtkPlotPoints::SQUARE);
    line->SetMarkerSize(static_cast<float>(font / 2.2));
  }
  style_axis(*xy->GetAxis(vtkAxis::LEFT), chart.y_title, font);
  style_axis(*xy->GetAxis(vtkAxis::BOTTOM), last ? axis.title : "", font);
  set_x(*xy->GetAxis(vtkAxis::BOTTOM), axis);
  set_y(*xy->GetAxis(vtkAxis::LEFT), chart);
  return xy;
}

/// Names beside the curves, from this corner down.
void add_legend(vtkRenderer& renderer, const Chart& chart, double x, double y, double font) {
  for (const Curve& curve : chart.curves) {
    add_box(renderer, x, y - 0.12 * font, 1.6 * font, 0.24 * font, curve.color);
    add_text(renderer, curve.name, {x + 2.1 * font, y}, 0.9 * font, kInk);
    y -= 1.35 * font;
  }
}

}  // namespace

Image draw_charts(const std::vector<Chart>& charts, const ChartAxis& axis, const std::string& title,
                  const std::array<int, 2>& size) {
  Window window;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window.vtk()->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  const auto width = static_cast<float>(size[0] * kScale);
  const auto height = static_cast<float>(size[1] * kScale);
  const double font = 0.017 * std::sqrt(static_cast<double>(width) * static_cast<double>(height));
  const auto top = static_cast<float>(title.empty() ? 0.4 * font : 2.4 * font);
  const float each = (height - top) / static_cast<float>(charts.size());
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const auto chart = make_chart(charts[i], axis, font, i + 1 == charts.size());
    if (i == 0 && !title.empty()) {
      chart->SetTitle(title);
      style_text(*chart->GetTitleProperties(), 1.2 * font);
    }
    const float bottom = height - top - each * static_cast<float>(i + 1);
    // The axes' own place, so that those of all charts stand below each other; beside it there is
    // room for titles and the longest legend.
    const auto letter = static_cast<float>(font);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetSize(
        vtkRectf(4.5f * letter, bottom + 3.2f * letter, width - 22 * letter, each - 3.9f * letter));
    actor->GetScene()->AddItem(chart);
    add_legend(*renderer, charts[i], width - 16.8 * font,
               static_cast<double>(bottom + each) - 1.4 * font, font);
  }
  actor->GetScene()->SetRenderer(renderer);
  renderer->AddActor(actor);
  return window.draw(size[0], size[1], kScale);
}

}  // namespace planescope::draw
