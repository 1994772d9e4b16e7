// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shape_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include "depth_order.hpp"
#include "palette.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

constexpr double kOpacity = 0.42;
constexpr double kOffWidth = 3.0;  // OFF edges over ON edges: told apart in black and white

/// Lines or polygons with a colour each, in the making.
struct Shapes {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colors;

  Shapes() { colors->SetNumberOfComponents(3); }

  template <typename Positions>
  void add(const Positions& positions, const Pixel& color) {
    cells->InsertNextCell(static_cast<int>(positions.size()));
    for (const Eigen::Vector3d& p : positions)
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    colors->InsertNextTypedTuple(color.data());
  }
};

vtkSmartPointer<vtkActor> make_actor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> line_actor(const Shapes& shapes, double width) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(shapes.points);
  data->SetLines(shapes.cells);
  data->GetCellData()->SetScalars(shapes.colors);
  auto actor = make_actor(data);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  return actor;
}

Eigen::Vector3d mix(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
  return a + t * (b - a);
}

/// `count` dashes of three fifths, with gaps between them.
void add_dashes(Shapes& lines, const Eigen::Vector3d& a, const Eigen::Vector3d& b, int count) {
  for (int i = 0; i < count; ++i)
    lines.add(std::array{mix(a, b, (i + 0.2) / count), mix(a, b, (i + 0.8) / count)}, kEdgeOff);
}

/// Dashes in an edge: as long as they are seen alike, and two at least.
int dash_count(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Camera& camera,
               const Pen& pen) {
  const double depth = std::max((a - camera.position).dot(camera.forward()), 1e-3);
  const double length = (b - a).norm() * pixels_per_metre(camera, pen.picture_height, depth);
  return std::clamp(static_cast<int>(std::lround(length / (3.6 * kOffWidth * pen.width))), 2, 12);
}

/// A dense graph is drawn with thinner lines, down to half their width, so that it does not become
/// one blue surface: a line is a twelfth of a patch's size, as seen at the scene's middle.
Pen for_patches(const Pen& pen, const SceneData& scene, const Camera& camera) {
  const double depth = (camera.focal - camera.position).norm();
  const double patch =
      scene.result.patch_size * pixels_per_metre(camera, pen.picture_height, depth);
  return {pen.width * std::clamp(patch / 12 / pen.width, 0.5, 1.0), pen.picture_height};
}

vtkSmartPointer<vtkActor> dot_actor(const std::vector<Eigen::Vector3d>& dots, double size) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (const Eigen::Vector3d& dot : dots)
    vertices->InsertNextCell({points->InsertNextPoint(dot.data())});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  auto actor = make_actor(data);
  use_splats(*actor, *vtkPolyDataMapper::SafeDownCast(actor->GetMapper()), "");
  PointScale scale;
  scale.fixed = size;
  set_point_scale(*actor, scale);
  actor->GetProperty()->SetColor(kEdgeOn[0] / 255.0, kEdgeOn[1] / 255.0, kEdgeOn[2] / 255.0);
  return actor;
}

std::vector<Eigen::Vector3d> lifted(const std::vector<Eigen::Vector3d>& corners,
                                    const Eigen::Vector3d& camera, double distance) {
  std::vector<Eigen::Vector3d> moved;
  moved.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners)
    moved.push_back(draw::lifted(corner, camera, distance));
  return moved;
}

/// Hull `i` of the scene's planes, as a polygon.
FlatPolygon hull(const SceneData& scene, vtkIdType i) {
  FlatPolygon polygon;
  polygon.source = static_cast<std::size_t>(i);
  for (const vtkIdType id : corners(*scene.planes->GetPolys(), i))
    polygon.corners.push_back(point(*scene.planes, id).cast<double>());
  vtkCellData& columns = *scene.planes->GetCellData();
  columns.GetArray("normal")->GetTuple(i, polygon.normal.data());
  polygon.distance = columns.GetArray("distance")->GetTuple1(i);
  return polygon;
}

}  // namespace

Eigen::Vector3d lifted(const Eigen::Vector3d& p, const Eigen::Vector3d& camera, double distance) {
  const Eigen::Vector3d ray = camera - p;
  const double length = ray.norm();
  return length > 0 ? Eigen::Vector3d(p + ray * (std::min(distance, length / 2) / length)) : p;
}

Actors plane_layer(const SceneData& scene, const SceneColors& colors, const Cutaway& cut,
                   const Camera& camera, const Pen& pen) {
  vtkCellData& columns = *scene.planes->GetCellData();
  vtkDataArray& plane = *columns.GetArray("plane");
  vtkDataArray& rms = *columns.GetArray("rms");
  std::vector<FlatPolygon> hulls;
  std::vector<double> lifts(static_cast<std::size_t>(scene.planes->GetNumberOfCells()));
  Shapes fills, outlines;
  for (vtkIdType i = 0; i < scene.planes->GetNumberOfCells(); ++i) {
    const auto index = static_cast<std::int32_t>(plane.GetTuple1(i));
    if (cut.hides(point(*scene.planes, corners(*scene.planes->GetPolys(), i)[0]), index)) continue;
    // Above the noise of the points on it, and their splats; the outline above the fill.
    const double lift = 2.5 * rms.GetTuple1(i) + 2 * scene.result.voxel_size;
    lifts[static_cast<std::size_t>(i)] = lift;
    hulls.push_back(hull(scene, i));
    std::vector<Eigen::Vector3d> outline = lifted(hulls.back().corners, camera.eye(), 1.25 * lift);
    outline.push_back(outline.front());
    outlines.add(outline, darken(colors.planes[static_cast<std::size_t>(index)], 0.45));
  }
  // Ordered where they are, and then lifted along the lines of sight, which changes no order.
  const auto pieces = painters_order(std::move(hulls), camera.eye());
  for (const FlatPolygon& piece : pieces) {
    const auto index =
        static_cast<std::size_t>(plane.GetTuple1(static_cast<vtkIdType>(piece.source)));
    fills.add(lifted(piece.corners, camera.eye(), lifts[piece.source]), colors.planes[index]);
  }
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(fills.points);
  polygons->SetPolys(fills.cells);
  polygons->GetCellData()->SetScalars(fills.colors);
  auto fill = make_actor(polygons);
  fill->GetProperty()->SetOpacity(kOpacity);
  return {fill, line_actor(outlines, 2.2 * pen.width)};
}

Actors graph_layer(const SceneData& scene, const Cutaway& cut, const Camera& camera,
                   const Pen& thin) {
  const Pen pen = for_patches(thin, scene, camera);
  vtkDataArray& plane = *scene.patches->GetPointData()->GetArray("plane");
  const double lift = 0.6 * scene.result.patch_size;
  const vtkIdType count = scene.patches->GetNumberOfPoints();
  std::vector<Eigen::Vector3d> places(static_cast<std::size_t>(count));
  std::vector<bool> hidden(places.size());
  std::vector<Eigen::Vector3d> dots;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    const Eigen::Vector3f centroid = point(*scene.graph, id);
    hidden[i] = cut.hides(centroid, static_cast<std::int32_t>(plane.GetTuple1(id)));
    places[i] = lifted(centroid.cast<double>(), camera.eye(), lift);
    if (!hidden[i]) dots.push_back(places[i]);
  }
  vtkDataArray& on = *scene.graph->GetCellData()->GetArray("on");
  Shapes on_lines, off_lines;
  for (vtkIdType i = 0; i < scene.graph->GetNumberOfCells(); ++i) {
    const auto ends = corners(*scene.graph->GetLines(), i);
    const auto a = static_cast<std::size_t>(ends[0]), b = static_cast<std::size_t>(ends[1]);
    if (hidden[a] || hidden[b]) continue;
    if (on.GetTuple1(i) != 0) {
      on_lines.add(std::array{places[a], places[b]}, kEdgeOn);
      continue;
    }
    const Eigen::Vector3d from = lifted(places[a], camera.eye(), lift / 4);  // above ON edges
    const Eigen::Vector3d to = lifted(places[b], camera.eye(), lift / 4);
    add_dashes(off_lines, from, to, dash_count(from, to, camera, pen));
  }
  return {line_actor(on_lines, pen.width), dot_actor(dots, 2.6 * pen.width),
          line_actor(off_lines, kOffWidth * pen.width)};
}

EdgeCounts count_edges(const SceneData& scene) {
  vtkDataArray& on = *scene.graph->GetCellData()->GetArray("on");
  EdgeCounts counts;
  for (vtkIdType i = 0; i < on.GetNumberOfTuples(); ++i)
    ++(on.GetTuple1(i) != 0 ? counts.on : counts.off);
  return counts;
}

}  // namespace planescope::draw
