// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/figure.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "caption.hpp"
#include "color_matching.hpp"
#include "drawing.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "validate.hpp"

/// \file render_figure(): where the panels stand, their captions, and their colours.
namespace planescope {
namespace {

using draw::Image;
using draw::Pixel;
using Labels = std::span<const std::uint32_t>;

constexpr double kGap = 1.5;  // [mm] between panels
constexpr double kTitlePoints = 7.5, kScorePoints = 7.0;
constexpr double kLine = 1.35;  // height of a line over its font

/// Pixels of everything, from the size in print.
struct Grid {
  int width = 0, height = 0;              // of the figure
  int panel_width = 0, panel_height = 0;  // of a panel without its caption
  int caption = 0, gap = 0;               // height of a caption; space between panels
  int columns = 1, rows = 1;

  int left(int column) const { return column * (panel_width + gap); }
  int top(int row) const { return row * (panel_height + caption + gap); }
};

Grid lay_out(const std::vector<FigurePanel>& panels, const FigureOptions& options) {
  const auto pixels = [&](double mm) {
    return static_cast<int>(std::lround(mm / 25.4 * options.dpi));
  };
  const bool scored =
      std::ranges::any_of(panels, [](const FigurePanel& p) { return !p.scores.empty(); });
  Grid grid;
  grid.columns = static_cast<int>(std::min<std::size_t>(options.columns, panels.size()));
  grid.rows = (static_cast<int>(panels.size()) + grid.columns - 1) / grid.columns;
  grid.gap = pixels(kGap);
  const double line = kLine * options.dpi / 72;
  grid.caption = static_cast<int>(std::lround((0.3 + 1) * kTitlePoints * line / kLine * 1.1 +
                                              (scored ? kScorePoints * line : 0)));
  grid.width = options.size ? options.size->at(0) : pixels(options.width_mm);
  grid.panel_width = (grid.width - grid.gap * (grid.columns - 1)) / grid.columns;
  const int around = grid.rows * grid.caption + (grid.rows - 1) * grid.gap;
  grid.height =
      options.size ? options.size->at(1) : around + grid.rows * (grid.panel_width * 3 / 4);
  grid.panel_height = (grid.height - around) / grid.rows;
  if (grid.panel_width < 16 || grid.panel_height < 16)
    throw Error(Error::Kind::Usage,
                "figure size " + std::to_string(grid.width) + "x" + std::to_string(grid.height) +
                    " leaves no room for " + std::to_string(panels.size()) +
                    " panels with captions; take a larger --size, or other --columns or --dpi");
  return grid;
}

void check(const PointCloud& cloud, const std::vector<FigurePanel>& panels,
           const FigureOptions& options) {
  if (panels.empty() || panels.size() > 26 || options.columns < 1 ||
      !(options.dpi >= 72 && options.dpi <= 1200) ||
      !(options.width_mm >= 10 && options.width_mm <= 1000))
    throw Error(Error::Kind::Usage,
                "figure: expected 1 to 26 panels, at least one column, 72 to "
                "1200 dpi and a width of 10 to 1000 mm");
  for (const FigurePanel& panel : panels) {
    if (!panel.labels.empty() && panel.labels.size() != cloud.size())
      throw Error(Error::Kind::Usage, "figure: panel `" + panel.title + "` has " +
                                          std::to_string(panel.labels.size()) + " labels for " +
                                          std::to_string(cloud.size()) + " points");
  }
}

/// Pairs of adjacent patches, of all edges.
draw::Neighbours patch_pairs(const PatchGraph& graph) {
  draw::Neighbours pairs;
  for (const Adjacency& edge : graph.adjacency) pairs.emplace_back(edge.first, edge.second);
  return pairs;
}

/// Per panel: the colour of each of its labels; nothing for own colours.
std::vector<std::vector<Pixel>> choose_label_colors(const Segmentation& scene,
                                                    const std::vector<FigurePanel>& panels) {
  std::vector<std::size_t> order;  // truth first
  for (const bool truth : {true, false})
    for (std::size_t i = 0; i < panels.size(); ++i)
      if (panels[i].is_truth == truth && !panels[i].labels.empty()) order.push_back(i);
  std::vector<Labels> labels;
  labels.reserve(order.size());
  for (const std::size_t i : order) labels.emplace_back(panels[i].labels);
  const draw::MatchedLabels matched = draw::match_labels(labels);
  const auto touching =
      draw::touching_objects(labels, matched, scene.graph.point_patch, scene.graph.patches.size(),
                             patch_pairs(scene.graph));
  const std::vector<Pixel> colors = draw::color_objects(
      matched, draw::objects_on_planes(labels, matched, scene.point_plane), touching);
  std::vector<std::vector<Pixel>> chosen(panels.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const std::uint32_t object : matched.object[k])
      chosen[order[k]].push_back(colors.empty() ? draw::kUnlabelled : colors[object]);
    chosen[order[k]][kNoSegment] = draw::kUnlabelled;
  }
  return chosen;
}

/// Centred below the panel; words that are too wide are made smaller.
void add_line(Image& figure, const std::string& text, double points, const FigureOptions& options,
              int left, int width, int top, const Pixel& ground) {
  if (text.empty()) return;
  Image words = draw::draw_text(text, points, options.dpi, draw::kInk, ground);
  if (words.width > width)
    words =
        draw::draw_text(text, points * 0.98 * width / words.width, options.dpi, draw::kInk, ground);
  if (words.width > width || top + words.height > figure.height) return;  // no room at all
  draw::paste(figure, words, left + (width - words.width) / 2, top);
}

std::vector<Pixel> color_points(const std::vector<std::uint32_t>& labels,
                                const std::vector<Pixel>& colors) {
  std::vector<Pixel> points;
  points.reserve(labels.size());
  for (const std::uint32_t label : labels) points.push_back(colors[label]);
  return points;
}

}  // namespace

void render_figure(const Segmentation& scene, const PointCloud& cloud,
                   const std::vector<FigurePanel>& panels, const FigureOptions& options,
                   const std::filesystem::path& png) {
  check(cloud, panels, options);
  const Grid grid = lay_out(panels, options);
  RenderOptions drawing = options.drawing;
  drawing.size = {grid.panel_width, grid.panel_height};
  draw::validate(drawing);
  Pixel ground{};
  for (std::size_t c = 0; c < 3; ++c)
    ground[c] = static_cast<std::uint8_t>(std::lround(255 * drawing.background[c]));
  const draw::SceneData data = draw::scene_data(scene, cloud);
  draw::Drawing pictures(data, drawing);
  const auto colors = choose_label_colors(scene, panels);
  Image figure = draw::filled(grid.width, grid.height, ground);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const FigurePanel& panel = panels[i];
    const int left = grid.left(static_cast<int>(i) % grid.columns);
    const int top = grid.top(static_cast<int>(i) / grid.columns);
    const Image picture =
        panel.labels.empty()
            ? pictures.draw(Layer::Scene, drawing.size, {})
            : pictures.draw_colored(color_points(panel.labels, colors[i]), drawing.size);
    draw::paste(figure, picture, left, top);
    const int below = top + grid.panel_height;
    const double point = options.dpi / 72;
    const std::string letter = std::string("(") + static_cast<char>('a' + i) + ") ";
    add_line(figure, letter + panel.title, kTitlePoints, options, left, grid.panel_width,
             below + static_cast<int>(0.3 * kTitlePoints * point), ground);
    add_line(figure, panel.scores, kScorePoints, options, left, grid.panel_width,
             below + static_cast<int>((0.3 + 1.2) * kTitlePoints * point), ground);
  }
  write_whole(png, draw::encode_png(figure, {.texts = {}, .dpi = options.dpi}));
}

}  // namespace planescope
