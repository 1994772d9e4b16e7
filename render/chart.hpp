// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "image.hpp"

/// \file Line charts, drawn by vtkChartXY in the window that draws scenes.
namespace planescope::draw {

/// A line of a chart; one value for each of the x values.
struct Curve {
  std::string name;
  std::vector<double> values;
  Pixel color{};
};

/// A chart: curves over the x values that all charts of a picture share.
struct Chart {
  std::string y_title;
  std::vector<Curve> curves;
  bool share = false;  ///< the y axis goes from 0 to 1
};

/// Where and how x values are written.
struct ChartAxis {
  std::string title;
  std::vector<double> values;
  std::vector<std::string> labels;  ///< of the values, where they are no numbers; else empty
};

/// Charts one below the other on white. \throws Error{Kind::Rendering} no context.
Image draw_charts(const std::vector<Chart>& charts, const ChartAxis& axis, const std::string& title,
                  const std::array<int, 2>& size);

}  // namespace planescope::draw
