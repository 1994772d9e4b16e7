// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_colors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "label_match.hpp"
#include "planescope/error.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

/// The value that would stand at this share of the sorted ones.
float ranked(std::vector<float>& values, double share) {
  const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

vtkDataArray& patch_column(const SceneData& scene, const char* name) {
  return *scene.patches->GetPointData()->GetArray(name);
}

/// How bright each patch is: 1 where it faces the lamp, less where it does not.
std::vector<float> patch_tones(const SceneData& scene, const Eigen::Vector3d& light) {
  constexpr double kShade = 0.24;
  vtkDataArray& normals = patch_column(scene, "normal");
  std::vector<float> tones;
  for (vtkIdType i = 0; i < normals.GetNumberOfTuples(); ++i) {
    Eigen::Vector3d normal;
    normals.GetTuple(i, normal.data());
    const double facing = light.isZero() ? 1 : std::abs(normal.dot(light));
    tones.push_back(static_cast<float>(1 - kShade * (1 - facing)));
  }
  return tones;
}

/// Candidates for what lies on planes, and for what does not.
std::vector<std::vector<Pixel>> candidates(Palette palette) {
  switch (palette) {
    case Palette::Vivid:
      return {vivid_colors(), vivid_colors()};
    case Palette::Pastel:
      return {calm_colors(), calm_colors()};
    case Palette::Grey:
      return {grey_colors(), grey_colors()};
    case Palette::Standard:
      break;
  }
  return {calm_colors(), vivid_colors()};
}

Neighbours patch_neighbours(const SceneData& scene) {
  Neighbours pairs;
  vtkCellArray& lines = *scene.graph->GetLines();
  for (vtkIdType i = 0; i < lines.GetNumberOfCells(); ++i) {
    const auto ends = corners(lines, i);
    pairs.emplace_back(ends[0], ends[1]);
  }
  return pairs;
}

/// Each plane in the hue of the largest segment on it; those that carry none, apart from theirs.
std::vector<Pixel> plane_colors(const Result& result, const std::vector<Pixel>& segments,
                                const std::vector<Pixel>& others) {
  std::vector<Pixel> colors;
  for (std::size_t i = 0; i < result.planes.size(); ++i)
    colors.push_back(deepened(others[i % others.size()]));
  std::vector<bool> known(result.planes.size(), false);
  for (const Segment& segment : result.segments) {  // largest first
    if (segment.plane == kNone || known[static_cast<std::size_t>(segment.plane)]) continue;
    known[static_cast<std::size_t>(segment.plane)] = true;
    colors[static_cast<std::size_t>(segment.plane)] = deepened(segments[segment.label - 1]);
  }
  return colors;
}

}  // namespace

std::string PointColors::name() const {
  return std::string("color") + (scene ? "-scene" : "") + (patches ? "-patches" : "") +
         (segments ? "-segments" : "") + (faded ? "-faded" : "") + "-" +
         std::to_string(static_cast<int>(by));
}

PointColors point_colors(Layer layers, ColorBy by) {
  if (by != ColorBy::Layers) return {false, false, false, false, by};
  const PointColors asked{has(layers, Layer::Scene), has(layers, Layer::Patches),
                          has(layers, Layer::Segments)};
  return asked.scene || asked.patches || asked.segments ? asked
                                                        : PointColors{true, false, false, true};
}

Neighbours segment_neighbours(const SceneData& scene) {
  vtkDataArray& label = patch_column(scene, "label");
  Neighbours pairs;
  for (const auto& [first, second] : patch_neighbours(scene)) {
    const auto a = static_cast<std::uint32_t>(label.GetTuple1(first));
    const auto b = static_cast<std::uint32_t>(label.GetTuple1(second));
    if (a != b && a > 0 && b > 0) pairs.emplace_back(std::min(a, b) - 1, std::max(a, b) - 1);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

SceneColors choose_colors(const SceneData& scene, Palette palette,
                          const std::vector<std::optional<Pixel>>& given) {
  const Result& result = scene.result;
  std::vector<std::size_t> groups;
  for (const Segment& segment : result.segments) groups.push_back(segment.plane == kNone ? 1 : 0);
  const auto palettes = candidates(palette);
  SceneColors colors;
  colors.segments = assign_colors(groups, palettes, segment_neighbours(scene), given);
  colors.planes = plane_colors(result, colors.segments, palettes[0]);
  return colors;
}

std::vector<Pixel> patch_colors(const SceneData& scene, Palette palette) {
  return assign_colors(std::vector<std::size_t>(scene.result.patch_count, 0),
                       {candidates(palette)[1]}, patch_neighbours(scene));
}

SceneColors scene_colors(const SceneData& scene, const RenderOptions& options) {
  if (!options.colors_of) return choose_colors(scene, options.palette);
  const SceneData other = scene_data(*options.colors_of);
  const Result& result = scene.result;
  if (other.result.cloud.size() != result.cloud.size())
    throw Error(Error::Kind::Usage,
                "colours of " + options.colors_of->string() + ": it has " +
                    std::to_string(other.result.cloud.size()) + " points, the scene has " +
                    std::to_string(result.cloud.size()) + "; name a result of the same cloud");
  const std::vector<Pixel> colors = choose_colors(other, options.palette).segments;
  std::vector<std::optional<Pixel>> given(result.segments.size());
  constexpr double kSame = 0.25;  // overlap of segments that are the same thing
  for (const LabelPair& pair : match_labels(other.result.point_label, result.point_label))
    if (pair.overlap >= kSame) given[pair.second - 1] = colors[pair.first - 1];
  return choose_colors(scene, options.palette, given);
}

void add_truth(SceneColors& colors, const SceneData& scene,
               const std::vector<std::uint32_t>& truth) {
  const Result& result = scene.result;
  if (truth.size() != result.cloud.size())
    throw Error(Error::Kind::Usage, "truth: has " + std::to_string(truth.size()) +
                                        " points, the scene has " +
                                        std::to_string(result.cloud.size()) +
                                        "; name the cloud that the scene was made from");
  std::map<std::uint32_t, std::uint32_t> compact;  // labels may be any numbers
  for (const std::uint32_t label : truth)
    if (label != 0) compact.emplace(label, 0);
  std::uint32_t next = 0;
  for (auto& [label, index] : compact) index = ++next;
  colors.truth.resize(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i)
    colors.truth[i] = truth[i] == 0 ? 0 : compact.at(truth[i]);
  colors.regions = matched_colors(result.point_label, colors.segments, colors.truth);
}

std::array<float, 2> height_range(const PointCloud& cloud, const Eigen::Vector3f& up) {
  std::vector<float> heights;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool taken = heights.size() < 100000 || i % 16 == 0;
    if (taken && is_finite(cloud.positions[i])) heights.push_back(cloud.positions[i].dot(up));
  }
  if (heights.empty()) return {0, 1};
  const float low = ranked(heights, 0.01);
  return {low, std::max(ranked(heights, 0.99), low + 1e-3F)};
}

std::array<float, 2> curvature_range(const SceneData& scene) {
  vtkDataArray& column = patch_column(scene, "curvature");
  std::vector<float> values;
  for (vtkIdType i = 0; i < column.GetNumberOfTuples(); ++i)
    values.push_back(static_cast<float>(column.GetTuple1(i)));
  return {0, values.empty() ? 1.0F : std::max(ranked(values, 0.95), 1e-6F)};
}

PointPainter::PointPainter(const SceneData& scene, const SceneColors& colors,
                           const Eigen::Vector3d& up, const Eigen::Vector3d& light)
    : scene_(scene), colors_(colors), up_(up.cast<float>()), tones_(patch_tones(scene, light)) {}

void PointPainter::prepare(ColorBy by) {
  vtkDataArray& normals = patch_column(scene_, "normal");
  vtkDataArray& curvature = patch_column(scene_, "curvature");
  const vtkIdType patches = normals.GetNumberOfTuples();
  if (by == ColorBy::Normal && normals_.empty()) {
    for (vtkIdType i = 0; i < patches; ++i) {
      Eigen::Vector3d normal;
      normals.GetTuple(i, normal.data());
      normals_.push_back(direction_color(normal));
    }
  }
  if (by == ColorBy::Curvature && curved_.empty()) {
    const double most = curvature_range(scene_)[1];
    for (vtkIdType i = 0; i < patches; ++i)
      curved_.push_back(ramp_color(curvature.GetTuple1(i) / most));
  }
}

Pixel PointPainter::height(std::size_t point) const {
  const auto& [low, high] = colors_.heights;
  return height_color((scene_.result.cloud.positions[point].dot(up_) - low) / (high - low));
}

Pixel PointPainter::scene_color(std::size_t point) const {
  const PointCloud& cloud = scene_.result.cloud;
  if (!scene_.result.has_colors || !cloud.has_colors()) return height(point);
  return {cloud.colors[point].r, cloud.colors[point].g, cloud.colors[point].b};
}

std::pair<Pixel, bool> PointPainter::single(std::size_t point, ColorBy by) const {
  const Result& result = scene_.result;
  const auto of = [](const std::vector<Pixel>& colors, std::int64_t index) {
    return index < 0 || index >= std::ssize(colors) ? kUnlabelled
                                                    : colors[static_cast<std::size_t>(index)];
  };
  const std::int32_t patch = result.point_patch[point];
  switch (by) {
    case ColorBy::Segment:
      return {of(colors_.segments, std::int64_t{result.point_label[point]} - 1), true};
    case ColorBy::Plane:
      return {of(colors_.planes, result.point_plane[point]), true};
    case ColorBy::Patch:
      return {of(colors_.patches, patch), true};
    case ColorBy::Normal:
      return {of(normals_, patch), false};
    case ColorBy::Curvature:
      return {of(curved_, patch), false};
    case ColorBy::Truth:
      return {colors_.truth.empty() ? kUnlabelled
                                    : of(colors_.regions, std::int64_t{colors_.truth[point]} - 1),
              true};
    case ColorBy::Height:
      return {height(point), true};
    case ColorBy::Rgb:
    case ColorBy::Layers:
      break;
  }
  return {scene_color(point), !result.has_colors};
}

Pixel PointPainter::averaged(std::size_t point, const PointColors& way) const {
  std::array<float, 3> sum{};
  float ways = 0;
  const auto add = [&](ColorBy by) {
    const auto [pixel, lit] = single(point, by);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c] * (lit ? tone(point) : 1.0F);
    ways += 1;
  };
  if (way.by != ColorBy::Layers) add(way.by);
  if (way.scene) add(ColorBy::Rgb);
  if (way.patches) add(ColorBy::Patch);
  if (way.segments) add(ColorBy::Segment);
  Pixel mean{};
  for (std::size_t c = 0; c < 3; ++c)
    mean[c] = static_cast<std::uint8_t>(sum[c] / std::max(ways, 1.0F));
  return mean;
}

Pixel PointPainter::operator()(std::size_t point, const PointColors& way) const {
  const Pixel mean = averaged(point, way);
  if (!way.faded) return mean;
  const auto grey = static_cast<std::uint8_t>(luma(mean));
  const auto faded = static_cast<std::uint8_t>(lighten({grey, grey, grey}, 0.78)[0] * tone(point));
  return {faded, faded, faded};
}

}  // namespace planescope::draw
