// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/vtk/segmentation_filter.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

#include "geometry.hpp"
#include "planescope/error.hpp"
#include "vtk_arrays.hpp"

namespace planescope {
namespace {

constexpr double kFar = 1000;  // [m] beyond it floats lose what a scan measures

/// Thrown through the stages where somebody asked to stop.
struct Aborted {};

Eigen::Vector3d choose_origin(vtkPolyData& data) {
  double bounds[6];
  data.GetBounds(bounds);
  const Eigen::Vector3d low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  if ((low.array().abs() <= kFar).all() && (high.array().abs() <= kFar).all())
    return Eigen::Vector3d::Zero();
  return ((low + high) / 2).array().round();
}

void add_colors(vtkPolyData& data, PointCloud& cloud) {
  auto* scalars = vtkUnsignedCharArray::SafeDownCast(data.GetPointData()->GetScalars());
  if (scalars == nullptr || scalars->GetNumberOfComponents() < 3) return;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i)
    cloud.colors.push_back({scalars->GetTypedComponent(i, 0), scalars->GetTypedComponent(i, 1),
                            scalars->GetTypedComponent(i, 2)});
}

void add_normals(vtkPolyData& data, PointCloud& cloud) {
  vtkDataArray* normals = data.GetPointData()->GetNormals();
  if (normals == nullptr) return;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    Eigen::Vector3d n;
    normals->GetTuple(i, n.data());
    cloud.normals.push_back(n.normalized().cast<float>());
  }
}

PointCloud to_cloud(vtkPolyData& data) {
  PointCloud cloud;
  const vtkIdType count = data.GetNumberOfPoints();
  if (count == 0) throw Error(Error::Kind::Input, "segmentation filter: the input has no point");
  cloud.origin = choose_origin(data);
  for (vtkIdType i = 0; i < count; ++i) {
    Eigen::Vector3d p;
    data.GetPoint(i, p.data());
    cloud.positions.push_back((p - cloud.origin).cast<float>());
  }
  cloud.width = static_cast<std::uint32_t>(count);
  add_colors(data, cloud);
  add_normals(data, cloud);
  return cloud;
}

void label_points(const Segmentation& scene, vtkPolyData& points) {
  const std::size_t count = scene.point_label.size();
  vtkPointData& columns = *points.GetPointData();
  columns.AddArray(draw::make_column<vtkUnsignedIntArray>(
      "label", count, [&](std::size_t i) { return scene.point_label[i]; }));
  columns.AddArray(draw::make_column<vtkIntArray>(
      "plane", count, [&](std::size_t i) { return scene.point_plane[i]; }));
  columns.AddArray(draw::make_column<vtkIntArray>(
      "patch", count, [&](std::size_t i) { return scene.graph.point_patch[i]; }));
  if (points.GetNumberOfCells() > 0) return;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < points.GetNumberOfPoints(); ++i) vertices->InsertNextCell({i});
  points.SetVerts(vertices);
}

/// Where in the whole a stage lies, of the time it usually takes.
double overall(std::string_view stage, double fraction) {
  if (stage == "patches") return 0.6 * fraction;
  if (stage == "hypotheses") return 0.6 + 0.2 * fraction;
  if (stage == "selection") return 0.8 + 0.05 * fraction;
  return 0.85 + 0.1 * fraction;  // assignment; edges and segments are quick
}

}  // namespace

vtkStandardNewMacro(SegmentationFilter);

SegmentationFilter::SegmentationFilter() {
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(3);
}

void SegmentationFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->Preset << "\n";
  for (const auto& [name, value] : given_) os << indent << name << ": " << value << "\n";
}

int SegmentationFilter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void SegmentationFilter::SetOption(const char* name, const char* value) {
  try {
    Options checked;
    set_option(checked, name, value);
  } catch (const Error& error) {
    vtkErrorMacro(<< error.what());
    return;
  }
  std::string& now = given_[name];
  if (now == value) return;
  now = value;
  this->Modified();
}

std::string SegmentationFilter::GetOption(const char* name) const {
  const auto found = given_.find(name);
  if (found != given_.end()) return found->second;
  return scene_.graph.patches.empty() ? std::string() : get_option(scene_.options, name);
}

void SegmentationFilter::ClearOptions() {
  if (!given_.empty()) this->Modified();
  given_.clear();
}

void SegmentationFilter::SetNumber(const char* name, double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  this->SetOption(name, text);
}

double SegmentationFilter::GetNumber(const char* name) const {
  const std::string text = this->GetOption(name);
  return text.empty() ? 0 : std::stod(text);
}

void SegmentationFilter::SetSensor(double x, double y, double z) {
  const std::array<double, 3> place{x, y, z};
  if (sensor_ && *sensor_ == place) return;
  sensor_ = std::make_unique<std::array<double, 3>>(place);
  this->Modified();
}

void SegmentationFilter::ClearSensor() {
  if (sensor_) this->Modified();
  sensor_.reset();
}

Options SegmentationFilter::ResolveOptions(const PointCloud& cloud) const {
  Options options;
  if (this->Preset == "auto") {
    options = Options::automatic(cloud);
  } else if (this->Preset == "tabletop") {
    options = Options::tabletop();
  } else if (this->Preset == "room") {
    options = Options::room();
  } else {
    throw Error(Error::Kind::Usage,
                "preset is `" + this->Preset + "`; it takes auto | room | tabletop");
  }
  for (const auto& [name, value] : given_) set_option(options, name, value);
  return options;
}

planescope::Progress SegmentationFilter::MakeProgress() {
  return [this](std::string_view stage, double fraction) {
    if (this->GetAbortExecute() != 0) throw Aborted{};
    this->SetProgressText(std::string(stage).c_str());
    this->UpdateProgress(std::max(this->GetProgress(), overall(stage, fraction)));
  };
}

int SegmentationFilter::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                    vtkInformationVector* outputs) {
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* points = vtkPolyData::GetData(outputs, PointsPort);
  scene_ = {};
  this->UpdateProgress(0);
  try {
    PointCloud cloud = to_cloud(*input);
    if (sensor_)
      cloud.sensor = (Eigen::Vector3d((*sensor_)[0], (*sensor_)[1], (*sensor_)[2]) - cloud.origin)
                         .cast<float>();
    scene_ = segment(cloud, this->ResolveOptions(cloud), this->MakeProgress());
    Eigen::Map<Eigen::Vector3d>(origin_.data()) = cloud.origin;
    points->ShallowCopy(input);
    label_points(scene_, *points);
    const auto put = [&](Port port, vtkPolyData& data) {
      if (!cloud.origin.isZero(0)) draw::move_points<vtkDoubleArray>(data, cloud.origin);
      vtkPolyData::GetData(outputs, port)->ShallowCopy(&data);
    };
    put(PlanesPort, *draw::plane_geometry(scene_, cloud));
    put(GraphPort, *draw::graph_geometry(scene_));
  } catch (const Aborted&) {
    return 1;
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  this->UpdateProgress(1);
  return 1;
}

}  // namespace planescope
