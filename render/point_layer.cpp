// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_layer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUniforms.h>
#include <vtkUnsignedCharArray.h>

#include "scene_box.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
std::vector<std::uint32_t> visible_points(const SceneData& scene, const Cutaway& cut) {
  const Result& result = scene.result;
  const SceneBox box(result);
  std::vector<std::uint32_t> points;
  for (std::size_t i = 0; i < result.cloud.size(); ++i) {
    const Eigen::Vector3f& p = result.cloud.positions[i];
    if (!box.holds(p) || (cut.any() && cut.hides(p, result.point_plane[i]))) continue;
    points.push_back(static_cast<std::uint32_t>(i));
  }
  return points;
}

PointLayer::PointLayer(const SceneData& scene, PointPainter& painter,
                       std::vector<std::uint32_t> points, const std::vector<float>& diameters)
    : scene_(scene),
      painter_(painter),
      points_(std::move(points)),
      data_(vtkSmartPointer<vtkPolyData>::New()),
      mapper_(vtkSmartPointer<vtkPolyDataMapper>::New()),
      actor_(vtkSmartPointer<vtkActor>::New()) {
  add_points();
  data_->GetPointData()->AddArray(make_column<vtkFloatArray>(
      "splat", points_.size(), [&](std::size_t i) { return diameters[i]; }));
  mapper_->SetInputData(data_);
  mapper_->SetColorModeToDirectScalars();
  mapper_->SetScalarModeToUsePointFieldData();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  use_splats(*actor_, *mapper_, "splat");
}

void PointLayer::add_points() {
  vtkNew<vtkPoints> points;
  points->SetData(make_vectors<vtkFloatArray>("position", points_.size(), [&](std::size_t i) {
    return scene_.result.cloud.positions[points_[i]];
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
}

Eigen::AlignedBox3d PointLayer::bounds() const {
  const double* b = data_->GetBounds();
  return {Eigen::Vector3d(b[0], b[2], b[4]), Eigen::Vector3d(b[1], b[3], b[5])};
}

void PointLayer::show(const PointColors& way) {
  const std::string name = way.name();
  if (data_->GetPointData()->GetArray(name.c_str()) == nullptr) {
    vtkNew<vtkUnsignedCharArray> array;  // four channels: VTK takes them as they are
    array->SetName(name.c_str());
    array->SetNumberOfComponents(4);
    array->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
    unsigned char* out = array->GetPointer(0);
    painter_.prepare(way.by);
    for (const std::uint32_t point : points_) {
      const Pixel pixel = painter_(point, way);
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
    const float tone = painter_.tone(point);
    for (const std::uint8_t channel : colors[point])
      *out++ = static_cast<unsigned char>(static_cast<float>(channel) * tone);
    *out++ = 255;
  }
  data_->GetPointData()->AddArray(array);  // in place of the one before
  mapper_->SelectColorArray(kName);
}

void PointLayer::scale(const PointScale& scale) {
  use_shape(*actor_, scale.shape);
  set_point_scale(*actor_, scale);
}

void use_splats(vtkActor& actor, vtkPolyDataMapper& mapper, const char* splat) {
  const bool by_array = *splat != '\0';
  if (by_array)
    mapper.MapDataArrayToVertexAttribute("splat", splat, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                         -1);
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  shader.AddVertexShaderReplacement(
      "//VTK::PositionVC::Dec", true,
      std::string("//VTK::PositionVC::Dec\n") + (by_array ? "in float splat;\n" : ""), false);
  // gl_Position.w is the depth along the view [m]; 1 in a parallel projection.
  shader.AddVertexShaderReplacement(
      "//VTK::PositionVC::Impl", true,
      std::string("//VTK::PositionVC::Impl\n  gl_PointSize = clamp(") +
          (by_array ? "splat * splatScale / gl_Position.w" : "splatLeast") +
          ", splatLeast, splatMost);\n",
      false);
}

void use_shape(vtkActor& actor, SplatShape shape) {
  constexpr const char* kPlace = "//VTK::Clip::Impl";  // before anything is worked out
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  shader.ClearFragmentShaderReplacement(kPlace, true);
  if (shape == SplatShape::Square) return;
  shader.AddFragmentShaderReplacement(
      kPlace, true,
      "vec2 fromMiddle = gl_PointCoord - 0.5;\n"
      "  if (dot(fromMiddle, fromMiddle) > 0.25) discard;\n  //VTK::Clip::Impl\n",
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
