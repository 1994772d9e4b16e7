// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/track_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "animation.hpp"
#include "chart.hpp"
#include "drawing.hpp"
#include "io/whole_file.hpp"
#include "palette.hpp"
#include "planescope/error.hpp"
#include "provenance.hpp"
#include "scene_data.hpp"
#include "validate.hpp"

namespace planescope {
namespace {

using draw::Chart;
using draw::Pixel;

/// Hues a golden angle apart: numbers near each other never look alike, whatever comes later.
Pixel object_color(std::uint32_t object) {
  constexpr double kGoldenAngle = 137.508;  // [deg]
  constexpr std::array<double, 3> kLightness = {0.72, 0.58, 0.82};
  return draw::from_oklch(kLightness[object % 3], 0.12, std::fmod(kGoldenAngle * object, 360.0));
}

template <class Value>
std::vector<double> column(const std::vector<TrackPlotRow>& rows, const Value& value) {
  std::vector<double> all;
  all.reserve(rows.size());
  for (const TrackPlotRow& row : rows) all.push_back(value(row));
  return all;
}

}  // namespace

Camera fit_camera(const Segmentation& scene, const PointCloud& cloud,
                  const RenderOptions& options) {
  draw::validate(options);
  const draw::SceneData data = draw::scene_data(scene, cloud);
  draw::Drawing drawing(data, options);
  drawing.draw(Layer::Scene, options.size, {});
  return draw::in_world(drawing.camera(), data);
}

std::string picture_of(const MapTracker& tracker, const RenderOptions& options,
                       const std::string& title) {
  draw::validate(options);
  if (tracker.scene().graph.patches.empty()) return {};
  const draw::SceneData data = draw::scene_data(tracker.scene(), tracker.map());
  std::vector<Pixel> colors;
  for (const std::uint32_t label : data.result.point_label) {
    colors.push_back(label == kNoSegment ? draw::kUnlabelled
                                         : object_color(tracker.objects()[label - 1]));
  }
  draw::Drawing drawing(data, options);
  drawing.allow_uniform();
  draw::Annotation words;
  words.title = title;
  return draw::encode_png(drawing.draw_marked(colors, options.size, words, {}));
}

void write_animation(const std::vector<std::string>& pngs, int milliseconds,
                     const std::filesystem::path& png) {
  if (pngs.empty()) throw Error(Error::Kind::Usage, "animation: there is no picture");
  write_whole(png, draw::animate(pngs, milliseconds));
}

void plot_track(const std::vector<TrackPlotRow>& rows, const std::string& title,
                const std::filesystem::path& png) {
  if (rows.empty()) throw Error(Error::Kind::Usage, "track: there is no frame to plot");
  constexpr Pixel kBlue = {31, 88, 168}, kAmber = {217, 119, 6}, kGreen = {30, 130, 90};
  const Chart times{
      "time a frame [ms]",
      {{"tracking", column(rows, [](const TrackPlotRow& r) { return r.tracking; }), kBlue},
       {"fusion", column(rows, [](const TrackPlotRow& r) { return r.fusion; }), kAmber}}};
  const Chart numbers{
      "number",
      {{"segments", column(rows, [](const TrackPlotRow& r) { return r.segments; }), kBlue},
       {"planes", column(rows, [](const TrackPlotRow& r) { return r.planes; }), kAmber}}};
  const Chart stability{
      "share that keeps its object",
      {{"of all places", column(rows, [](const TrackPlotRow& r) { return r.kept; }), kAmber},
       {"of those seen often", column(rows, [](const TrackPlotRow& r) { return r.steady_kept; }),
        kGreen}},
      true};
  draw::ChartAxis axis{"frame", column(rows, [](const TrackPlotRow& r) { return r.frame; }), {}};
  draw::PngNotes notes;
  notes.texts.emplace_back("Software", "planescope " PLANESCOPE_VERSION ", VTK " + vtk_version());
  draw::write_png(draw::draw_charts({times, numbers, stability}, axis, title, {1200, 1000}), png,
                  notes);
}

}  // namespace planescope
