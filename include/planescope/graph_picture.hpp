// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "planescope/edges.hpp"
#include "planescope/render.hpp"

/// \file The patch graph, coloured by what was decided and why (target planescope::render).
namespace planescope {

/// What the colour of an edge says. Truth: edges ON across two true objects, OFF inside one, right
/// ones and those that cannot be judged (judge_edges()); points that were merged into another
/// object, split off or missed are tinted (judge_points()).
enum class EdgeColor { State, Rule, Margin, Truth };

/// Which edges are drawn and counted: those that pass all that is asked.
struct EdgeFilter {
  std::optional<bool> on;
  std::optional<EdgeRule> rule;
  double margin_below = std::numeric_limits<double>::infinity();
};

struct GraphOptions {
  EdgeColor color = EdgeColor::State;
  EdgeFilter only;
};

/// A line of the legend.
struct LegendCount {
  std::string name;
  std::size_t count = 0;
};

/// What was drawn.
struct GraphPicture {
  Camera camera;
  std::vector<LegendCount> edges;   ///< kinds of edges that pass the filter; walls that are left
                                    ///< out of the picture still count
  std::vector<LegendCount> points;  ///< errors of points, with EdgeColor::Truth
};

/// Draws the graph of a result folder as tubes over faded points, with a legend that counts.
/// \param options as for render(). Of the layers planes are drawn beneath, and segments give the
/// points a pale shade where they are asked for with others (segments alone are the default, and do
/// not); the title stands over the legend. With EdgeColor::Truth `options.truth` must be there.
/// \throws Error{Kind::Usage} no truth, or of another number of points; a picture of less than 320
/// x 200 pixels. \throws otherwise as render().
GraphPicture render_graph(const std::filesystem::path& folder, const RenderOptions& options,
                          const GraphOptions& graph, const std::filesystem::path& png);

/// `off`, `on`, `rule=concave`, `margin<0.1`, joined by commas: all of them must hold.
/// \throws Error{Kind::Usage} something else.
EdgeFilter parse_edge_filter(const std::string& text);

}  // namespace planescope
