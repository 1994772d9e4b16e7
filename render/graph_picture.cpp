// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/graph_picture.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "close_up.hpp"
#include "drawing.hpp"
#include "edge_classes.hpp"
#include "figure.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"
#include "planescope/truth_errors.hpp"
#include "provenance.hpp"
#include "solids.hpp"
#include "vtk_arrays.hpp"

namespace planescope {
namespace {

using draw::EdgeClass;
using draw::EdgeClasses;
using draw::PanelLine;
using draw::Pixel;
using draw::SceneData;
using Style = PanelLine::Style;

constexpr double kPanelShare = 0.2;  // of the picture's width
constexpr double kMeasure = 19;      // of the legend: its width over its letters' size
constexpr Pixel kFaint = {118, 121, 127};

/// How points are told apart that went wrong; right ones are faded. Indexed by PointError.
struct PointKind {
  const char* name;
  Pixel color;
};
constexpr std::array<PointKind, kPointErrorCount> kPointKinds = {
    {{"right", {225, 227, 230}},
     {"merged into another object", {244, 150, 165}},
     {"split off their object", {196, 160, 232}},
     {"in no segment", {90, 90, 90}},
     {"without truth", {240, 240, 238}}}};

/// Points as the ground of the graph: faded, or a pale shade of their segment.
std::vector<Pixel> ground(const SceneData& scene, const draw::SceneColors& colors, bool segments) {
  const Result& result = scene.result;
  std::vector<Pixel> pixels(result.cloud.size(), Pixel{222, 223, 225});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::uint32_t label = result.point_label[i];
    if (segments && label != kNoSegment) {
      pixels[i] = draw::lighten(colors.segments[label - 1], 0.6);
    } else if (result.has_colors) {
      const Rgb rgb = result.cloud.colors[i];
      const auto grey = static_cast<std::uint8_t>(draw::luma({rgb.r, rgb.g, rgb.b}));
      pixels[i] = draw::lighten({grey, grey, grey}, 0.78);
    }
  }
  return pixels;
}

void tint(std::vector<Pixel>& pixels, const std::vector<PointError>& errors) {
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (errors[i] != PointError::None && errors[i] != PointError::Unjudged)
      pixels[i] = kPointKinds[static_cast<std::size_t>(errors[i])].color;
}

/// The edges as tubes as thick as is seen alike, thick kinds over thin ones.
draw::Solids tubes(const SceneData& scene, const EdgeClasses& classes, const draw::Cutaway& cut,
                   const Camera& camera, const draw::Pen& pen) {
  vtkDataArray& plane = *scene.patches->GetPointData()->GetArray("plane");
  draw::Solids solids;
  const auto hidden = [&](vtkIdType patch) {
    return cut.hides(draw::point(*scene.graph, patch),
                     static_cast<std::int32_t>(plane.GetTuple1(patch)));
  };
  for (vtkIdType i = 0; i < scene.graph->GetNumberOfCells(); ++i) {
    const std::uint8_t kind = classes.of[static_cast<std::size_t>(i)];
    if (kind == EdgeClasses::kHidden) continue;
    const auto ends = draw::corners(*scene.graph->GetLines(), i);
    if (hidden(ends[0]) || hidden(ends[1])) continue;
    const EdgeClass& look = classes.kinds[kind];
    const double lift = (0.5 + 0.08 * look.width) * scene.result.patch_size;
    const auto place = [&](vtkIdType patch) {
      return draw::lifted(draw::point(*scene.graph, patch).cast<double>(), camera.eye(), lift);
    };
    const Eigen::Vector3d a = place(ends[0]), b = place(ends[1]);
    const double depth = std::max(((a + b) / 2 - camera.position).dot(camera.forward()), 1e-3);
    const double radius =
        look.width * pen.width / 2 / draw::pixels_per_metre(camera, pen.picture_height, depth);
    solids.add_tube(a, b, std::min(radius, 0.03 * look.width * scene.result.patch_size),
                    look.color);
  }
  return solids;
}

/// Points, planes and edges, without the legend. \param errors of the points, or empty.
draw::Image draw_view(draw::Drawing& drawing, const SceneData& scene, const RenderOptions& options,
                      const EdgeClasses& classes, const std::vector<PointError>& errors) {
  const draw::Shot& shot = drawing.shot();
  // Segments alone are what one gets who asked for no layers.
  const bool segments = options.layers != Layer::Segments && has(options.layers, Layer::Segments);
  std::vector<Pixel> pixels = ground(scene, drawing.colors(), segments);
  if (!errors.empty()) tint(pixels, errors);
  const auto [width, height] = options.size;
  const Camera camera = shot.camera(static_cast<double>(width) / height, {});
  const draw::Pen pen{options.supersample * std::max(1.0, std::hypot(width, height) / 1300),
                      static_cast<double>(height) * options.supersample};
  draw::Actors shapes;
  if (has(options.layers, Layer::Planes))
    shapes = draw::plane_layer(scene, drawing.colors(), shot.cut(), camera, pen);
  const draw::Solids solids = tubes(scene, classes, shot.cut(), camera, pen);
  if (solids.size() > 0) shapes.push_back(solids.actor());
  return drawing.draw_marked(pixels, options.size, {}, shapes);
}

std::vector<PanelLine> legend(const std::string& title, const EdgeClasses& classes,
                              const GraphPicture& picture, bool cut) {
  std::vector<PanelLine> lines;
  if (!title.empty()) lines.push_back({title, Style::Title, draw::kInk});
  std::size_t all = 0;
  for (const EdgeClass& kind : classes.kinds) all += kind.count;
  lines.push_back({draw::grouped(all) + " edges", Style::Strong, draw::kInk});
  for (const EdgeClass& kind : classes.kinds)
    if (kind.count > 0)
      lines.push_back({kind.name + ": " + draw::grouped(kind.count), Style::Swatch, kind.color});
  if (!picture.points.empty()) {
    lines.push_back({"", Style::Space, {}});
    lines.push_back({"Points", Style::Strong, draw::kInk});
  }
  for (std::size_t i = 0; i < picture.points.size(); ++i)
    lines.push_back(
        {std::string(kPointKinds[i].name) + ": " + draw::grouped(picture.points[i].count),
         Style::Swatch, kPointKinds[i].color});
  if (!cut) return lines;
  lines.push_back({"", Style::Space, {}});
  lines.push_back(
      {"walls between camera and room are left out; their edges count", Style::Small, kFaint});
  return lines;
}

/// What the picture holds, for its PNG.
std::string note(const GraphPicture& picture) {
  nlohmann::ordered_json counts = nlohmann::ordered_json::object();
  for (const LegendCount& line : picture.edges) counts[line.name] = line.count;
  for (const LegendCount& line : picture.points)
    counts[std::string("points_").append(line.name)] = line.count;
  return counts.dump();
}

void check(const RenderOptions& options, const GraphOptions& graph) {
  if (options.size[0] < 320 || options.size[1] < 200)
    throw Error(Error::Kind::Usage, "graph picture size " + std::to_string(options.size[0]) + "x" +
                                        std::to_string(options.size[1]) +
                                        ": must be 320x200 at least, to hold the legend");
  if (graph.color == EdgeColor::Truth && options.truth.empty())
    throw Error(Error::Kind::Usage,
                "edges by truth: there is no truth; name a cloud with true labels");
}

EdgeRule parse_rule(const std::string& text, const std::string& all) {
  std::string names;
  for (std::size_t i = 0; i < kEdgeRuleCount; ++i) {
    const std::string_view rule = name(static_cast<EdgeRule>(i));
    if (text == rule) return static_cast<EdgeRule>(i);
    names.append(names.empty() ? "" : " | ").append(rule);
  }
  throw Error(Error::Kind::Usage, "only is `" + all + "`; rule= takes " + names);
}

}  // namespace

GraphPicture render_graph(const std::filesystem::path& folder, const RenderOptions& options,
                          const GraphOptions& graph, const std::filesystem::path& png) {
  check(options, graph);
  const SceneData scene = draw::scene_data(folder);
  std::vector<std::uint32_t> truth;
  GraphPicture picture;
  std::vector<PointError> errors;
  if (graph.color == EdgeColor::Truth) {
    truth = patch_truth(scene.result.point_patch, options.truth, scene.result.patch_count);
    errors = judge_points(scene.result.point_label, options.truth);
    const auto counts = count_errors(errors);
    for (std::size_t i = 0; i < kPointErrorCount; ++i)
      picture.points.push_back({std::string(name(static_cast<PointError>(i))), counts[i]});
  }
  const EdgeClasses classes = draw::classify(scene, graph, truth);
  for (const EdgeClass& kind : classes.kinds) picture.edges.push_back({kind.key, kind.count});

  const int panel = static_cast<int>(std::lround(kPanelShare * options.size[0]));
  RenderOptions drawn = options;
  drawn.size = {options.size[0] - panel, options.size[1]};
  drawn.annotation.title.clear();
  draw::Drawing drawing(scene, drawn);
  const draw::Image view = draw_view(drawing, scene, drawn, classes, errors);
  const auto lines = legend(options.annotation.title, classes, picture, drawing.shot().cut().any());
  draw::Image whole = draw::filled(options.size[0], options.size[1], {255, 255, 255});
  draw::paste(whole, view, 0, 0);
  draw::paste(whole, draw::draw_panel(lines, panel, options.size[1], drawn.supersample, kMeasure),
              drawn.size[0], 0);
  picture.camera = draw::in_world(drawing.camera(), scene);
  draw::PngNotes notes = draw::provenance(scene, options, Layer::Graph, picture.camera);
  notes.texts.emplace_back("planescope:graph", note(picture));
  draw::write_png(whole, png, notes);
  return picture;
}

EdgeFilter parse_edge_filter(const std::string& text) {
  EdgeFilter filter;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    constexpr std::string_view kRule = "rule=", kMargin = "margin<";
    if (part == "on" || part == "off") {
      filter.on = part == "on";
    } else if (part.starts_with(kRule)) {
      filter.rule = parse_rule(part.substr(kRule.size()), text);
    } else {
      double value = 0;
      const std::size_t skipped = std::min(part.size(), kMargin.size());
      const char* stop = part.data() + part.size();
      const auto [at, failure] = std::from_chars(part.data() + skipped, stop, value);
      if (!part.starts_with(kMargin) || failure != std::errc() || at != stop || !(value > 0))
        throw Error(Error::Kind::Usage, "only is `" + text +
                                            "`; it takes off, on, rule=NAME and margin<X, joined "
                                            "by commas");
      filter.margin_below = value;
    }
  }
  return filter;
}

}  // namespace planescope
