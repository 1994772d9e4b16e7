// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "solids.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include "hull.hpp"

namespace planescope::draw {
namespace {

constexpr int kSides = 12;

}  // namespace

Solids::Solids() {
  normals_->SetNumberOfComponents(3);
  normals_->SetName("normal");
  colors_->SetNumberOfComponents(3);
  colors_->SetName("color");
}

vtkIdType Solids::add_point(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                            const Pixel& color) {
  normals_->InsertNextTuple(normal.data());
  colors_->InsertNextTypedTuple(color.data());
  return points_->InsertNextPoint(p.data());
}

void Solids::add_frustum(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double from, double to,
                         const Pixel& color) {
  const double length = (b - a).norm();
  if (!(length > 0)) return;
  const Eigen::Vector3d axis = (b - a) / length;
  const auto [u, v] = plane_axes(axis);
  const double slope = (from - to) / length;
  std::array<vtkIdType, kSides> at_a{}, at_b{};
  for (std::size_t i = 0; i < kSides; ++i) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(i) / kSides;
    const Eigen::Vector3d out = std::cos(turn) * u + std::sin(turn) * v;
    const Eigen::Vector3d normal = (out + slope * axis).normalized();
    at_a[i] = add_point(a + from * out, normal, color);
    at_b[i] = add_point(b + to * out, normal, color);
  }
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t next = (i + 1) % kSides;
    cells_->InsertNextCell({at_a[i], at_a[next], at_b[next], at_b[i]});
  }
}

void Solids::add_arrow(const Eigen::Vector3d& tail, const Eigen::Vector3d& tip, double radius,
                       const Pixel& color) {
  const Eigen::Vector3d neck = tail + 0.72 * (tip - tail);
  add_tube(tail, neck, radius, color);
  add_frustum(neck - 1e-3 * (tip - tail), neck, radius, 2.6 * radius, color);  // the head's back
  add_frustum(neck, tip, 2.6 * radius, 0, color);
}

void Solids::add_ball(const Eigen::Vector3d& center, double radius, const Pixel& color) {
  constexpr int kRings = 8;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  for (int ring = 0; ring < kRings; ++ring) {
    const auto angle = [](int k) {
      return std::numbers::pi * (static_cast<double>(k) / kRings - 0.5);
    };
    const double low = angle(ring), high = angle(ring + 1);
    add_frustum(center + radius * std::sin(low) * up, center + radius * std::sin(high) * up,
                radius * std::cos(low), radius * std::cos(high), color);
  }
}

vtkSmartPointer<vtkActor> Solids::actor() const {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetPolys(cells_);
  data->GetPointData()->SetNormals(normals_);
  data->GetPointData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.55);
  return actor;
}

}  // namespace planescope::draw
