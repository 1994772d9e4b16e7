// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "marks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "label_places.hpp"
#include "overlay.hpp"
#include "palette.hpp"
#include "point_layer.hpp"
#include "thinning.hpp"

namespace planescope::draw {
namespace {

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// Areas of one legend have the same number of digits.
std::string area_text(double square_metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m\u00b2", square_metres);
  return text;
}

LegendEntry box(const Pixel& color, const std::string& text) {
  return {LegendEntry::Swatch::Box, color, text};
}

std::vector<LegendEntry> segment_legend(const SceneData& scene, const SceneColors& colors) {
  std::vector<LegendEntry> legend;
  for (const Segment& segment : scene.result.segments)
    legend.push_back(box(colors.segments[segment.label - 1],
                         std::to_string(segment.label) + ": " + area_text(segment.area)));
  return legend;
}

std::vector<LegendEntry> plane_legend(const SceneData& scene, const SceneColors& colors) {
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < scene.result.planes.size(); ++i)
    legend.push_back(box(colors.planes[i], std::string(name(scene.result.planes[i].role)) + " " +
                                               std::to_string(i) + ": " +
                                               area_text(scene.result.planes[i].area)));
  return legend;
}

/// The cell of a place in normalised coordinates; the nearest one of those outside.
std::array<int, 2> cell(const LabelMap& map, const Eigen::Vector3d& seen) {
  const auto along = [](double share, int count) {
    return static_cast<int>(std::clamp(std::floor(share * count), 0.0, count - 1.0));
  };
  return {along((seen.x() + 1) / 2, map.width), along((1 - seen.y()) / 2, map.height)};
}

/// Colours of a quantity at its ends and in the middle.
template <typename Map>
std::vector<LegendEntry> ramp_legend(const std::array<float, 2>& range, const Map& map,
                                     const std::string& unit) {
  std::vector<LegendEntry> legend;
  for (const double t : {0.0, 0.5, 1.0}) {
    const double value = range[0] + t * (range[1] - range[0]);
    // No -0.00445 m: what is nothing of the range is 0.
    const bool none = std::abs(value) < 0.005 * std::abs(range[1] - range[0]);
    legend.push_back(box(map(t), short_number(none ? 0 : value) + unit));
  }
  return legend;
}

}  // namespace

std::string length_text(double metres) {
  if (metres >= 0.995) return short_number(metres) + " m";
  if (metres >= 0.00995) return short_number(metres * 100) + " cm";
  return short_number(metres * 1000) + " mm";
}

std::vector<LegendEntry> color_legend(const SceneData& scene, const SceneColors& colors,
                                      const PointColors& way, Layer layers) {
  switch (way.by) {
    case ColorBy::Segment:
      return segment_legend(scene, colors);
    case ColorBy::Plane:
      return plane_legend(scene, colors);
    case ColorBy::Curvature:
      return ramp_legend(curvature_range(scene), ramp_color, "");
    case ColorBy::Height:
      return ramp_legend(colors.heights, height_color, " m");
    case ColorBy::Normal:
      return {box(direction_color({1, 0, 0}), "x"), box(direction_color({0, 1, 0}), "y"),
              box(direction_color({0, 0, 1}), "z")};
    case ColorBy::Layers:
      if (way.segments) return segment_legend(scene, colors);
      if (way.faded && has(layers, Layer::Planes)) return plane_legend(scene, colors);
      if (way.scene && !way.faded && !way.patches && !scene.result.has_colors)
        return ramp_legend(colors.heights, height_color, " m");
      return {};
    case ColorBy::Patch:
    case ColorBy::Truth:
    case ColorBy::Rgb:
      break;
  }
  return {};
}

namespace {

/// Which segment is seen in each cell of `side` pixels: that of the nearest point.
LabelMap seen_labels(const SceneData& scene, const Cutaway& cut, const Camera& camera,
                     const Layout& layout, int side) {
  LabelMap map{std::max(1, layout.width / side), std::max(1, layout.height / side), {}};
  map.labels.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), 0);
  const PointCloud& cloud = scene.result.cloud;
  const double aspect = static_cast<double>(layout.width) / layout.height;
  for (const std::uint32_t i :
       nearest_per_pixel(cloud, visible_points(scene, cut), camera, map.width, map.height, 0)) {
    const auto [x, y] = cell(map, project(camera, aspect, cloud.positions[i].cast<double>()));
    map.labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
               static_cast<std::size_t>(x)] = scene.result.point_label[i];
  }
  return map;
}

}  // namespace

std::vector<Mark> segment_marks(const SceneData& scene, const Cutaway& cut, const Camera& camera,
                                const Layout& layout) {
  const double aspect = static_cast<double>(layout.width) / layout.height;
  const int side = std::max(3, layout.font / 3);
  const LabelMap map = seen_labels(scene, cut, camera, layout, side);
  const auto& segments = scene.result.segments;
  const auto places = label_places(
      map, static_cast<std::uint32_t>(segments.size()),
      [&](std::uint32_t label) {
        return cell(map, project(camera, aspect, segments[label - 1].centroid.cast<double>()));
      },
      [&](std::uint32_t label) {
        return 1 + static_cast<int>(text_width(std::to_string(label), layout.font) / (2 * side));
      },
      2);
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const auto& [x, y] = *places[i];
    marks.push_back(
        {std::to_string(i + 1), {2 * (x + 0.5) / map.width - 1, 1 - 2 * (y + 0.5) / map.height}});
  }
  return marks;
}

ScaleBar scale_bar(const Camera& camera, const Layout& layout) {
  const double depth = (camera.focal - camera.position).norm();
  const double metre = pixels_per_metre(camera, layout.height, depth);
  const double most = 0.2 * layout.width / metre;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double length = most >= 5 * power ? 5 * power : most >= 2 * power ? 2 * power : power;
  return {length * metre / layout.width,
          length_text(length) + (camera.parallel() ? "" : " mid-scene")};
}

std::vector<AxisMark> axis_marks(const Camera& camera) {
  // Red, green and blue as everywhere, in hues that a colour-blind reader tells apart; and named.
  static constexpr std::array<Pixel, 3> kColors = {Pixel{213, 70, 20}, {0, 138, 96}, {30, 90, 190}};
  std::vector<std::pair<double, AxisMark>> axes;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i);
    axes.push_back({axis.dot(camera.forward()),
                    {{axis.dot(camera.right()), axis.dot(camera.up)},
                     kColors[static_cast<std::size_t>(i)],
                     std::string(1, static_cast<char>('x' + i))}});
  }
  std::stable_sort(axes.begin(), axes.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<AxisMark> marks;
  marks.reserve(axes.size());
  for (auto& [away, mark] : axes) marks.push_back(std::move(mark));
  return marks;
}

}  // namespace planescope::draw
