// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "annotation.hpp"

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

#include "palette.hpp"

namespace planescope::draw {
namespace {

constexpr double kLetter = 0.56;  // a letter's width over the font's size, generously
constexpr double kSwatch = 2.2;   // a swatch's width over the font's size
constexpr double kGap = 0.5;      // between swatch and text, over the font's size

double text_width(const std::string& text, int font) {
  return kLetter * font * static_cast<double>(text.size());
}

double legend_width(const std::vector<LegendEntry>& legend, int font) {
  double width = 0;
  for (const LegendEntry& entry : legend)
    width += text_width(entry.text, font) + (kSwatch + 3 * kGap) * font;
  return width;
}

void add_text(vtkRenderer& renderer, const std::string& text, double x, double y, double size,
              const Pixel& color) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  vtkTextProperty& style = *actor->GetTextProperty();
  style.SetFontFamilyToArial();
  style.SetFontSize(static_cast<int>(size));
  style.SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  style.SetVerticalJustificationToCentered();
  actor->SetPosition(x, y);
  renderer.AddActor2D(actor);
}

/// A filled rectangle, in the pixels of the picture that is drawn.
void add_box(vtkRenderer& renderer, double x, double y, double width, double height,
             const Pixel& color) {
  vtkNew<vtkPoints> points;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    points->InsertNextPoint(std::round(x + dx * width), std::round(y + dy * height), 0);
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

void add_swatch(vtkRenderer& renderer, const LegendEntry& entry, double x, double y, double font) {
  const double width = kSwatch * font;
  switch (entry.swatch) {
    case LegendEntry::Swatch::Box:
      add_box(renderer, x, y - 0.4 * font, width, 0.8 * font, entry.color);
      break;
    case LegendEntry::Swatch::ThinLine:
      add_box(renderer, x, y - 0.05 * font, width, 0.1 * font, entry.color);
      break;
    case LegendEntry::Swatch::DashedLine:
      for (const double start : {0.0, 0.37, 0.74})
        add_box(renderer, x + start * width, y - 0.13 * font, 0.26 * width, 0.26 * font,
                entry.color);
      break;
  }
}

}  // namespace

Layout::Layout(int width_, int height_, const Annotation& annotation)
    : width(width_), height(height_) {
  const double side = std::sqrt(static_cast<double>(width) * height);
  font = std::max(8, static_cast<int>(std::lround(0.023 * side)));
  const double words =
      text_width(annotation.title, font) + legend_width(annotation.legend, font) + 2 * font;
  legend_below_title = !annotation.title.empty() && !annotation.legend.empty() && words > width;
  const double lines = !annotation.has_band() ? 0 : legend_below_title ? 3.3 : 1.9;
  band = std::min(static_cast<int>(std::lround(lines * font)), height / 2);
  footer = annotation.note.empty() ? 0 : std::min(static_cast<int>(1.3 * font), height / 4);
}

void annotate(vtkRenderer& renderer, const Annotation& annotation, const Layout& layout, int scale,
              const std::array<double, 3>& background) {
  const double font = static_cast<double>(layout.font) * scale;
  const double width = static_cast<double>(layout.width) * scale;
  Pixel ground{};
  for (std::size_t c = 0; c < 3; ++c)
    ground[c] = static_cast<std::uint8_t>(std::lround(255 * background[c]));
  add_box(renderer, 0, static_cast<double>(layout.height - layout.band) * scale, width,
          static_cast<double>(layout.band) * scale, ground);
  add_box(renderer, 0, 0, width, static_cast<double>(layout.footer) * scale, ground);
  double y = static_cast<double>(layout.height) * scale - 1.05 * font;
  if (!annotation.title.empty()) add_text(renderer, annotation.title, 0.6 * font, y, font, kInk);
  if (layout.legend_below_title) y -= 1.4 * font;
  const double all = legend_width(annotation.legend, layout.font) * scale;
  double x = layout.legend_below_title ? 0.6 * font : std::max(0.6 * font, width - all);
  for (const LegendEntry& entry : annotation.legend) {
    add_swatch(renderer, entry, x, y, font);
    add_text(renderer, entry.text, x + (kSwatch + kGap) * font, y, font, kInk);
    x += text_width(entry.text, layout.font) * scale + (kSwatch + 3 * kGap) * font;
  }
  if (!annotation.note.empty())
    add_text(renderer, annotation.note, 0.6 * font, 0.75 * font, 0.72 * font, kUnlabelled);
}

}  // namespace planescope::draw
