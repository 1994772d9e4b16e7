// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "caption.hpp"
#include "close_up.hpp"
#include "palette.hpp"

namespace planescope::draw {
namespace {

constexpr Pixel kPaper = {255, 255, 255};
constexpr double kDpi = 72;  // so that points are pixels

double size_of(PanelLine::Style style, double font) {
  switch (style) {
    case PanelLine::Style::Title:
      return 1.45 * font;
    case PanelLine::Style::Strong:
      return 1.1 * font;
    case PanelLine::Style::Small:
    case PanelLine::Style::Row:
      return 0.85 * font;
    default:
      return font;
  }
}

/// The text as an image, broken into as many as are needed to keep within `width`.
std::vector<Image> broken(const PanelLine& line, double size, int width) {
  std::vector<Image> rows;
  std::istringstream words(line.text);
  std::string row, word;
  const auto image = [&](const std::string& text) {
    const bool swatch = line.style == PanelLine::Style::Swatch;
    return draw_text(text, size, kDpi, swatch ? kInk : line.color, kPaper);
  };
  while (words >> word) {
    std::string longer = row;
    if (!row.empty()) longer += ' ';
    longer += word;
    if (!row.empty() && image(longer).width > width) {
      rows.push_back(image(row));
      row = word;
    } else {
      row = longer;
    }
  }
  if (!row.empty()) rows.push_back(image(row));
  return rows;
}

void paste_clipped(Image& canvas, const Image& piece, int x, int y) {
  if (x < 0 || y < 0 || y + piece.height > canvas.height) return;
  if (x + piece.width <= canvas.width) {
    paste(canvas, piece, x, y);
    return;
  }
  if (x >= canvas.width) return;
  paste(canvas, shrunk(piece, canvas.width - x, piece.height), x, y);  // one word too long
}

/// The cells of a row at their columns, one line high.
double add_row(Image& panel, const PanelLine& line, double size, int margin, int room, double y) {
  constexpr std::array<double, 3> kColumns = {0, 0.55, 0.75};
  std::istringstream cells(line.text);
  std::string cell;
  for (std::size_t i = 0; i < kColumns.size() && std::getline(cells, cell, '\t'); ++i) {
    if (cell.empty()) continue;
    paste_clipped(panel, draw_text(cell, size, kDpi, line.color, kPaper),
                  margin + static_cast<int>(kColumns[i] * room), static_cast<int>(y));
  }
  return 1.45 * size;
}

}  // namespace

Image draw_panel(const std::vector<PanelLine>& lines, int width, int height, int scale,
                 double measure) {
  Image panel = filled(width * scale, height * scale, kPaper);
  const double font = std::max(7.0, std::min(width / measure, height / 44.0)) * scale;
  const int margin = static_cast<int>(font), room = panel.width - 2 * margin;
  double y = font;
  for (const PanelLine& line : lines) {
    const double size = size_of(line.style, font);
    const int indent = line.style == PanelLine::Style::Swatch ? static_cast<int>(1.5 * font) : 0;
    if (line.style == PanelLine::Style::Space) y += 0.7 * font;
    if (line.style == PanelLine::Style::Row) {
      y += add_row(panel, line, size, margin, room, y);
      continue;
    }
    bool first = true;
    for (const Image& row : broken(line, size, room - indent)) {
      if (indent > 0 && first) {
        const int side = static_cast<int>(font);
        paste_clipped(panel, filled(side, side, line.color), margin,
                      static_cast<int>(y + (row.height - side) / 2.0));
      }
      first = false;
      paste_clipped(panel, row, margin + indent, static_cast<int>(y));
      y += std::max(1.35 * size, row.height + 0.2 * size);
    }
  }
  return downsample(panel, scale);
}

}  // namespace planescope::draw
