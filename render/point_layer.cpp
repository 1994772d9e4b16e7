// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_layer.hpp"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUniforms.h>
#include <vtkUnsignedCharArray.h>

#include "palette.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

constexpr double kOverlap = 1.7;  // splat over spacing: random samples close to the eye

/// The median of values, 0 without any.
float median(std::vector<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// sqrt(area / points) of each patch [m], held within a factor of four of their median.
std::vector<float> patch_spacings(const SceneData& scene) {
  vtkDataArray& area = *scene.patches->GetPointData()->GetArray("area");
  vtkDataArray& count = *scene.patches->GetPointData()->GetArray("point_count");
  std::vector<float> spacings;
  for (vtkIdType i = 0; i < area.GetNumberOfTuples(); ++i) {
    const double ratio = area.GetTuple1(i) / std::max(count.GetTuple1(i), 1.0);
    spacings.push_back(static_cast<float>(std::sqrt(std::max(ratio, 0.0))));
  }
  const float usual = median(spacings);
  for (float& spacing : spacings) spacing = std::clamp(spacing, usual / 4, usual * 4);
  return spacings;
}

/// [m] What stands in for it where the method has no patches.
float cloud_spacing(const PointCloud& cloud) {
  return static_cast<float>(measure_scale(cloud).spacing);
}

/// How bright each patch is: 1 where it faces the lamp, less where it does not.
std::vector<float> patch_tones(const SceneData& scene, const Eigen::Vector3d& light) {
  constexpr double kShade = 0.24;
  vtkDataArray& normals = *scene.patches->GetPointData()->GetArray("normal");
  std::vector<float> tones;
  for (vtkIdType i = 0; i < normals.GetNumberOfTuples(); ++i) {
    Eigen::Vector3d normal;
    normals.GetTuple(i, normal.data());
    const double facing = light.isZero() ? 1 : std::abs(normal.dot(light));
    tones.push_back(static_cast<float>(1 - kShade * (1 - facing)));
  }
  return tones;
}

}  // namespace

std::string PointColors::name() const {
  return std::string("color") + (scene ? "-scene" : "") + (patches ? "-patches" : "") +
         (segments ? "-segments" : "") + (faded ? "-faded" : "");
}

SceneColors choose_colors(const SceneData& scene) {
  const Result& result = scene.result;
  vtkDataArray& label = *scene.patches->GetPointData()->GetArray("label");
  vtkDataArray& plane = *scene.patches->GetPointData()->GetArray("plane");
  Neighbours patches, segments, planes;
  vtkCellArray& lines = *scene.graph->GetLines();
  for (vtkIdType i = 0; i < lines.GetNumberOfCells(); ++i) {
    const auto ends = corners(lines, i);
    patches.emplace_back(ends[0], ends[1]);
    const auto a = label.GetTuple1(ends[0]), b = label.GetTuple1(ends[1]);
    if (a != b && a > 0 && b > 0)
      segments.emplace_back(static_cast<std::uint32_t>(a) - 1, static_cast<std::uint32_t>(b) - 1);
    const auto p = plane.GetTuple1(ends[0]), q = plane.GetTuple1(ends[1]);
    if (p != q && p >= 0 && q >= 0)
      planes.emplace_back(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q));
  }
  std::vector<std::size_t> groups;
  for (const Segment& segment : result.segments) groups.push_back(segment.plane == kNone ? 1 : 0);
  const std::vector<Pixel> vivid = vivid_colors();
  return {assign_colors(groups, {calm_colors(), vivid}, segments),
          assign_colors(std::vector<std::size_t>(result.planes.size(), 0), {vivid}, planes),
          assign_colors(std::vector<std::size_t>(result.patch_count, 0), {vivid}, patches)};
}

PointLayer::PointLayer(const SceneData& scene, const SceneColors& colors, const Eigen::Vector3d& up,
                       const Eigen::Vector3d& light, const Cutaway& cut)
    : scene_(scene),
      colors_(colors),
      up_(up.cast<float>()),
      tones_(patch_tones(scene, light)),
      data_(vtkSmartPointer<vtkPolyData>::New()),
      mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
  add_points(cut);
  data_->GetPointData()->AddArray(splats());
  mapper_->SetInputData(data_);
  mapper_->SetColorModeToDirectScalars();
  mapper_->SetScalarModeToUsePointFieldData();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  use_splats(*actor_, *mapper_, "splat");
}

void PointLayer::add_points(const Cutaway& cut) {
  const Result& result = scene_.result;
  std::vector<float> heights;
  for (std::size_t i = 0; i < result.cloud.size(); ++i) {
    const Eigen::Vector3f& p = result.cloud.positions[i];
    if (!is_finite(p)) continue;
    if (heights.size() < 100000 || i % 16 == 0) heights.push_back(p.dot(up_));
    if (cut.any() && cut.hides(p, result.point_plane[i])) continue;
    points_.push_back(static_cast<std::uint32_t>(i));
  }
  vtkNew<vtkPoints> points;
  points->SetData(make_vectors<vtkFloatArray>("position", points_.size(), [&](std::size_t i) {
    return result.cloud.positions[points_[i]];
  }));
  data_->SetPoints(points);
  // One cell of all points: VTK walks over cells more slowly than over their corners.
  const auto count = static_cast<int>(points_.size());
  auto offsets = make_column<vtkTypeInt32Array>("offsets", 2,
                                                [&](std::size_t i) { return i == 0 ? 0 : count; });
  auto ids = make_column<vtkTypeInt32Array>("ids", points_.size(), [](std::size_t i) { return i; });
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, ids);
  data_->SetVerts(vertices);
  if (heights.empty()) return;
  // The map of heights is not stretched by a few strays.
  std::sort(heights.begin(), heights.end());
  lowest_ = heights[heights.size() / 100];
  highest_ = std::max(heights[heights.size() - 1 - heights.size() / 100], lowest_ + 1e-3F);
}

vtkSmartPointer<vtkFloatArray> PointLayer::splats() const {
  const std::vector<float> spacing = patch_spacings(scene_);
  const float usual = spacing.empty() ? cloud_spacing(scene_.result.cloud) : median(spacing);
  return make_column<vtkFloatArray>("splat", points_.size(), [&](std::size_t i) {
    const std::int32_t patch = scene_.result.point_patch[points_[i]];
    return kOverlap * (patch == kNone ? usual : spacing[static_cast<std::size_t>(patch)]);
  });
}

Pixel PointLayer::scene_color(std::size_t point) const {
  const PointCloud& cloud = scene_.result.cloud;
  if (scene_.result.has_colors && cloud.has_colors())
    return {cloud.colors[point].r, cloud.colors[point].g, cloud.colors[point].b};
  return height_color((cloud.positions[point].dot(up_) - lowest_) / (highest_ - lowest_));
}

Pixel PointLayer::color(std::size_t point, const PointColors& way) const {
  const Result& result = scene_.result;
  const std::int32_t patch = result.point_patch[point];
  const float tone = patch == kNone ? 1.0F : tones_[static_cast<std::size_t>(patch)];
  std::array<float, 3> sum{};
  float ways = 0;
  const auto add = [&](const Pixel& pixel, float brightness) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c] * brightness;
    ways += 1;
  };
  if (way.scene) add(scene_color(point), result.has_colors ? 1.0F : tone);
  if (way.patches)
    add(patch == kNone ? kUnlabelled : colors_.patches[static_cast<std::size_t>(patch)], tone);
  if (way.segments) {
    const std::uint32_t label = result.point_label[point];
    add(label == kNoSegment ? kUnlabelled : colors_.segments[label - 1], tone);
  }
  Pixel mean{};
  for (std::size_t c = 0; c < 3; ++c)
    mean[c] = static_cast<std::uint8_t>(sum[c] / std::max(ways, 1.0F));
  if (!way.faded) return mean;
  const auto grey = static_cast<std::uint8_t>(luma(mean));
  const auto faded = static_cast<std::uint8_t>(lighten({grey, grey, grey}, 0.78)[0] * tone);
  return {faded, faded, faded};
}

void PointLayer::show(const PointColors& way) {
  const std::string name = way.name();
  if (data_->GetPointData()->GetArray(name.c_str()) == nullptr) {
    vtkNew<vtkUnsignedCharArray> array;  // four channels: VTK takes them as they are
    array->SetName(name.c_str());
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
    unsigned char* out = array->GetPointer(0);
    for (const std::uint32_t point : points_) {
      const Pixel pixel = color(point, way);
      out = std::copy(pixel.begin(), pixel.end(), out);
      *out++ = 255;
    }
    data_->GetPointData()->AddArray(array);
  }
  mapper_->SelectColorArray(name.c_str());
}

void PointLayer::show(const std::vector<Pixel>& colors) {
  constexpr const char* kName = "color-given";
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(kName);
  array->SetNumberOfComponents(4);
  array->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
  unsigned char* out = array->GetPointer(0);
  for (const std::uint32_t point : points_) {
    const std::int32_t patch = scene_.result.point_patch[point];
    const float tone = patch == kNone ? 1.0F : tones_[static_cast<std::size_t>(patch)];
    for (const std::uint8_t channel : colors[point])
      *out++ = static_cast<unsigned char>(static_cast<float>(channel) * tone);
    *out++ = 255;
  }
  data_->GetPointData()->AddArray(array);  // in place of the one before
  mapper_->SelectColorArray(kName);
}

void PointLayer::scale(const PointScale& scale) { set_point_scale(*actor_, scale); }

void use_splats(vtkActor& actor, vtkPolyDataMapper& mapper, const char* splat) {
  const bool by_array = *splat != '\0';
  if (by_array)
    mapper.MapDataArrayToVertexAttribute("splat", splat, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                         -1);
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  shader.AddVertexShaderReplacement(
      "//VTK::PositionVC::Dec", true,
      std::string("//VTK::PositionVC::Dec\n") + (by_array ? "in float splat;\n" : ""), false);
  // gl_Position.w is the depth along the view [m].
  shader.AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true,
      std::string("//VTK::PositionVC::Impl\n  gl_PointSize = clamp(") +
          (by_array ? "splat * splatScale / gl_Position.w" : "splatLeast") +
          ", splatLeast, splatMost);\n",
      false);
}

void set_point_scale(vtkActor& actor, const PointScale& scale) {
  vtkUniforms& uniforms = *actor.GetShaderProperty()->GetVertexCustomUniforms();
  const auto set = [&](const char* name, double value) {
    uniforms.SetUniformf(name, static_cast<float>(value));
  };
  set("splatScale", scale.pixels_per_metre_at_1m);
  set("splatLeast", scale.fixed > 0 ? scale.fixed : scale.least);
  set("splatMost", scale.fixed > 0 ? scale.fixed : scale.most);
}

}  // namespace planescope::draw
