// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sheets.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include "depth_order.hpp"
#include "palette.hpp"

namespace planescope::draw {
namespace {

constexpr double kOpacity = 0.22;

/// Cells of one kind with a colour each.
struct Cells {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;

  Cells() { colors->SetNumberOfComponents(3); }

  void add(const std::vector<Eigen::Vector3d>& corners, const Pixel& color) {
    cells->InsertNextCell(static_cast<int>(corners.size()));
    for (const Eigen::Vector3d& p : corners)
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    colors->InsertNextTypedTuple(color.data());
  }

  vtkSmartPointer<vtkActor> actor(bool lines) const {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    lines ? data->SetLines(cells) : data->SetPolys(cells);
    data->GetCellData()->SetScalars(colors);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    return actor;
  }
};

std::vector<Eigen::Vector3d> raised(std::vector<Eigen::Vector3d> corners, const Camera& camera,
                                    double lift) {
  for (Eigen::Vector3d& corner : corners) corner = lifted(corner, camera.eye(), lift);
  return corners;
}

}  // namespace

Actors sheet_actors(const std::vector<Sheet>& sheets, const Camera& camera, double width,
                    double lift) {
  Cells fills, outlines;
  std::vector<FlatPolygon> polygons;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const Sheet& sheet = sheets[i];
    if (sheet.corners.size() < 3) continue;
    polygons.push_back({sheet.corners, sheet.normal, sheet.normal.dot(sheet.corners[0]), i});
    std::vector<Eigen::Vector3d> around = sheet.corners;
    around.push_back(around.front());
    outlines.add(raised(around, camera, 1.2 * lift), darken(sheet.color, 0.25));
  }
  const auto pieces = painters_order(std::move(polygons), camera.eye());
  for (const FlatPolygon& piece : pieces)
    fills.add(raised(piece.corners, camera, lift), sheets[piece.source].color);
  if (fills.cells->GetNumberOfCells() == 0) return {};
  auto fill = fills.actor(false);
  fill->GetProperty()->SetOpacity(kOpacity);
  auto outline = outlines.actor(true);
  outline->GetProperty()->SetLineWidth(static_cast<float>(width));
  return {outline, fill};
}

}  // namespace planescope::draw
