// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "annotation.hpp"

#include <algorithm>
#include <cmath>

#include "overlay.hpp"
#include "palette.hpp"

namespace planescope::draw {
namespace {

constexpr double kSwatch = 2.2;  // a swatch's width over the font's size
constexpr double kGap = 0.5;     // between swatch and text, over the font's size
constexpr double kSmall = 0.72;  // of the font: note, bar, marks

/// Of the swatch and the gap beside it, over the font's size.
double swatch_width(const LegendEntry& entry) {
  return entry.swatch == LegendEntry::Swatch::None ? 0 : kSwatch + kGap;
}

double legend_width(const std::vector<LegendEntry>& legend, int font) {
  double width = 0;
  for (const LegendEntry& entry : legend)
    width += text_width(entry.text, font) + (swatch_width(entry) + 2 * kGap) * font;
  return width;
}

/// Colours of words on a background.
struct Inks {
  Inks(const std::array<double, 3>& background, const std::array<double, 3>& words_on) {
    Pixel under{};
    for (std::size_t c = 0; c < 3; ++c) {
      ground[c] = static_cast<std::uint8_t>(std::lround(255 * background[c]));
      under[c] = static_cast<std::uint8_t>(std::lround(255 * words_on[c]));
    }
    const bool dark = luma(under) < 110;
    ink = dark ? Pixel{228, 230, 234} : kInk;
    faint = dark ? Pixel{165, 168, 174} : Pixel{118, 121, 127};
  }
  Pixel ground{}, ink{}, faint{};
};

/// Where things are put, in pixels of the picture that is drawn.
struct Sheet {
  vtkRenderer& renderer;
  double width, height, font, band, footer;
  Inks inks;
};

void add_swatch(const Sheet& sheet, const LegendEntry& entry, double x, double y) {
  const double font = sheet.font, width = kSwatch * font;
  switch (entry.swatch) {
    case LegendEntry::Swatch::Box:
      add_box(sheet.renderer, x, y - 0.4 * font, width, 0.8 * font, entry.color);
      break;
    case LegendEntry::Swatch::ThinLine:
      add_box(sheet.renderer, x, y - 0.05 * font, width, 0.1 * font, entry.color);
      break;
    case LegendEntry::Swatch::DashedLine:
      for (const double start : {0.0, 0.37, 0.74})
        add_box(sheet.renderer, x + start * width, y - 0.13 * font, 0.26 * width, 0.26 * font,
                entry.color);
      break;
    case LegendEntry::Swatch::None:
      break;
  }
}

void add_band(const Sheet& sheet, const Annotation& annotation, bool legend_below_title) {
  const double font = sheet.font;
  double y = sheet.height - 1.05 * font;
  if (!annotation.title.empty())
    add_text(sheet.renderer, annotation.title, {0.6 * font, y}, font, sheet.inks.ink);
  if (legend_below_title) y -= 1.4 * font;
  const double all = legend_width(annotation.legend, 1000) * font / 1000;
  double x = legend_below_title ? 0.6 * font : std::max(0.6 * font, sheet.width - all);
  for (const LegendEntry& entry : annotation.legend) {
    add_swatch(sheet, entry, x, y);
    add_text(sheet.renderer, entry.text, {x + swatch_width(entry) * font, y}, font, sheet.inks.ink);
    x += text_width(entry.text, font) + (swatch_width(entry) + 2 * kGap) * font;
  }
}

void add_scale_bar(const Sheet& sheet, const ScaleBar& bar) {
  const double font = sheet.font, right = sheet.width - 0.8 * font;
  const double left = right - bar.share * sheet.width, y = 0.6 * font, thick = 0.14 * font;
  add_box(sheet.renderer, left, y - thick / 2, right - left, thick, sheet.inks.ink);
  for (const double x : {left, right - thick})
    add_box(sheet.renderer, x, y - 0.32 * font, thick, 0.64 * font, sheet.inks.ink);
  add_text(sheet.renderer, bar.text, {(left + right) / 2, 1.35 * font}, kSmall * font,
           sheet.inks.ink, Anchor::Centre);
}

/// The diagonal that is furthest from all arms.
std::array<double, 2> free_corner(const std::vector<AxisMark>& axes) {
  std::array<double, 2> best = {-1, 1};
  double least = 2;
  for (const std::array<double, 2>& corner :
       std::array<std::array<double, 2>, 4>{{{-1, 1}, {-1, -1}, {1, 1}, {1, -1}}}) {
    double most = -2;  // alignment with an arm
    for (const AxisMark& axis : axes)
      most = std::max(most, corner[0] * axis.tip[0] + corner[1] * axis.tip[1]);
    if (most < least - 1e-9) {
      least = most;
      best = corner;
    }
  }
  return best;
}

void add_axes(const Sheet& sheet, const std::vector<AxisMark>& axes) {
  const double font = sheet.font, arm = 2.2 * font;
  const double x = 3.4 * font, y = sheet.footer + 3.2 * font;
  for (const AxisMark& axis : axes) {
    const double dx = arm * axis.tip[0], dy = arm * axis.tip[1];
    add_line(sheet.renderer, {x, y}, {x + dx, y + dy}, 0.16 * font, axis.color);
    const double length = std::hypot(dx, dy);
    if (length < 0.35 * font) {  // along the view: a dot, and its name where no arm is
      add_box(sheet.renderer, x - 0.2 * font, y - 0.2 * font, 0.4 * font, 0.4 * font, axis.color);
      const auto [away_x, away_y] = free_corner(axes);
      add_text(sheet.renderer, axis.name, {x + 0.7 * font * away_x, y + 0.7 * font * away_y},
               0.85 * font, axis.color, Anchor::Centre);
      continue;
    }
    const double reach = (length + 0.55 * font) / length;
    add_text(sheet.renderer, axis.name, {x + dx * reach, y + dy * reach}, 0.85 * font, axis.color,
             Anchor::Centre);
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
  const double below = annotation.scale_bar ? 2.0 : annotation.note.empty() ? 0 : 1.3;
  footer = std::min(static_cast<int>(below * font), height / 4);
}

void shorten_legend(Annotation& annotation, int width, int height) {
  const int font = Layout(width, height, {}).font;
  std::size_t dropped = 0;
  const auto too_wide = [&] {
    const std::string rest = "and " + std::to_string(dropped) + " more";
    const double more = dropped > 0 ? text_width(rest, font) + 2 * kGap * font : 0;
    return legend_width(annotation.legend, font) + more > width - font;
  };
  while (annotation.legend.size() > 1 && too_wide()) {
    annotation.legend.pop_back();
    ++dropped;
  }
  if (dropped == 0) return;
  annotation.legend.push_back(
      {LegendEntry::Swatch::None, {}, "and " + std::to_string(dropped) + " more"});
}

std::size_t thin_out(std::vector<Mark>& marks, const Layout& layout) {
  struct Box {
    double left, right, bottom, top;
  };
  const double font = kSmall * layout.font;
  std::vector<Box> taken;
  return std::erase_if(marks, [&](const Mark& mark) {
    const double x = (mark.place[0] + 1) / 2 * layout.width;
    const double y = (mark.place[1] + 1) / 2 * layout.height;
    const double half = text_width(mark.text, font) / 2;
    const Box box{x - half, x + half, y - 0.6 * font, y + 0.6 * font};
    const bool inside = box.left >= 0 && box.right <= layout.width && box.bottom >= layout.footer &&
                        box.top <= layout.height - layout.band;
    const bool free = std::ranges::none_of(taken, [&](const Box& other) {
      return box.left < other.right && other.left < box.right && box.bottom < other.top &&
             other.bottom < box.top;
    });
    if (!inside || !free) return true;
    taken.push_back(box);
    return false;
  });
}

void annotate(vtkRenderer& renderer, const Annotation& annotation, const Layout& layout, int scale,
              const std::array<double, 3>& background, const std::array<double, 3>& words_on) {
  const auto drawn = [&](int pixels) { return static_cast<double>(pixels) * scale; };
  const Sheet sheet{
      renderer,           drawn(layout.width),  drawn(layout.height),      drawn(layout.font),
      drawn(layout.band), drawn(layout.footer), Inks(background, words_on)};
  for (const Mark& mark : annotation.marks)
    add_text(renderer, mark.text,
             {(mark.place[0] + 1) / 2 * sheet.width, (mark.place[1] + 1) / 2 * sheet.height},
             kSmall * sheet.font, sheet.inks.ink, Anchor::Centre, &sheet.inks.ground);
  add_box(renderer, 0, sheet.height - sheet.band, sheet.width, sheet.band, sheet.inks.ground);
  add_box(renderer, 0, 0, sheet.width, sheet.footer, sheet.inks.ground);
  add_band(sheet, annotation, layout.legend_below_title);
  if (!annotation.note.empty())
    add_text(renderer, annotation.note, {0.6 * sheet.font, 0.75 * sheet.font}, kSmall * sheet.font,
             sheet.inks.faint);
  if (annotation.scale_bar) add_scale_bar(sheet, *annotation.scale_bar);
  add_axes(sheet, annotation.axes);
}

}  // namespace planescope::draw
