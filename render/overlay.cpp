// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "overlay.hpp"

#include <algorithm>
#include <cmath>

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace planescope::draw {
namespace {

constexpr double kLetter = 0.56;  // a letter's width over the font's size, generously

void add_quad(vtkRenderer& renderer, const std::array<std::array<double, 2>, 4>& corners,
              const Pixel& color) {
  vtkNew<vtkPoints> points;
  for (const auto& [x, y] : corners) points->InsertNextPoint(x, y, 0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  renderer.AddActor2D(actor);
}

}  // namespace

double text_width(const std::string& text, double font) {
  // Bytes that continue a letter of UTF-8 are none of their own.
  const auto letters = std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned>(c) & 0xC0U) != 0x80U; });
  return kLetter * font * static_cast<double>(letters);
}

void add_text(vtkRenderer& renderer, const std::string& text, const std::array<double, 2>& place,
              double size, const Pixel& color, Anchor anchor, const Pixel* ground) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  vtkTextProperty& style = *actor->GetTextProperty();
  style.SetFontFamilyToArial();
  style.SetFontSize(static_cast<int>(size));
  style.SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  style.SetVerticalJustificationToCentered();
  if (anchor == Anchor::Centre) style.SetJustificationToCentered();
  if (anchor == Anchor::Right) style.SetJustificationToRight();
  if (ground != nullptr) {
    style.SetBackgroundColor((*ground)[0] / 255.0, (*ground)[1] / 255.0, (*ground)[2] / 255.0);
    style.SetBackgroundOpacity(0.75);
  }
  actor->SetPosition(place[0], place[1]);
  renderer.AddActor2D(actor);
}

void add_box(vtkRenderer& renderer, double x, double y, double width, double height,
             const Pixel& color) {
  const double left = std::round(x), right = std::round(x + width);
  const double bottom = std::round(y), top = std::round(y + height);
  add_quad(renderer, {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}}, color);
}

void add_line(vtkRenderer& renderer, const std::array<double, 2>& from,
              const std::array<double, 2>& to, double width, const Pixel& color) {
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  const double length = std::hypot(dx, dy);
  if (!(length > 0)) return;
  const double x = -dy / length * width / 2, y = dx / length * width / 2;
  add_quad(renderer,
           {{{from[0] - x, from[1] - y},
             {to[0] - x, to[1] - y},
             {to[0] + x, to[1] + y},
             {from[0] + x, from[1] + y}}},
           color);
}

}  // namespace planescope::draw
