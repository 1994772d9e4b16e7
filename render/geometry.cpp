// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry.hpp"

#include <map>
#include <utility>
#include <vector>

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>

#include "hull.hpp"
#include "vtk_arrays.hpp"

namespace planescope::draw {
namespace {

using Group = std::pair<std::int32_t, std::uint32_t>;  // plane, label

vtkSmartPointer<vtkPoints> centroids(const std::vector<Patch>& patches) {
  auto points = vtkSmartPointer<vtkPoints>::New();  // single precision
  points->SetData(make_vectors<vtkFloatArray>("centroid", patches.size(),
                                              [&](std::size_t i) { return patches[i].centroid; }));
  return points;
}

void add_membership(const Segmentation& scene, vtkDataSetAttributes& data) {
  const std::size_t count = scene.graph.patches.size();
  data.AddArray(
      make_column<vtkIntArray>("plane", count, [&](std::size_t i) { return scene.plane_of(i); }));
  data.AddArray(make_column<vtkUnsignedIntArray>(
      "label", count, [&](std::size_t i) { return scene.segments.patch_label[i]; }));
}

/// The points of each pair of plane and segment, in plane coordinates.
std::map<Group, std::vector<Eigen::Vector2d>> points_on_planes(const Segmentation& scene,
                                                               const PointCloud& cloud) {
  std::map<Group, std::vector<Eigen::Vector2d>> groups;
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> axes;
  for (const SupportingPlane& p : scene.planes)
    axes.push_back(plane_axes(p.plane.normal.cast<double>()));
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Group group{scene.point_plane[i], scene.point_label[i]};
    if (group.first == kNone || group.second == kNoSegment) continue;
    const auto& [u, v] = axes[static_cast<std::size_t>(group.first)];
    const Eigen::Vector3d p = cloud.positions[i].cast<double>();
    groups[group].emplace_back(p.dot(u), p.dot(v));
  }
  return groups;
}

/// A hull and what is said of it in planes.vtp.
struct Hull {
  Group group;
  std::vector<Eigen::Vector2d> corners;
  std::size_t point_count = 0;
};

std::vector<Hull> make_hulls(const Segmentation& scene, const PointCloud& cloud) {
  std::vector<Hull> hulls;
  for (auto& [group, points] : points_on_planes(scene, cloud)) {
    const std::size_t count = points.size();
    std::vector<Eigen::Vector2d> corners = convex_hull(std::move(points));
    if (corners.size() >= 3) hulls.push_back({group, std::move(corners), count});
  }
  return hulls;
}

void add_polygons(const Segmentation& scene, const std::vector<Hull>& hulls, vtkPolyData& data) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (const Hull& hull : hulls) {
    const Plane& plane = scene.planes[static_cast<std::size_t>(hull.group.first)].plane;
    const Eigen::Vector3d normal = plane.normal.cast<double>();
    const auto [u, v] = plane_axes(normal);
    polygons->InsertNextCell(static_cast<int>(hull.corners.size()));
    for (const Eigen::Vector2d& corner : hull.corners) {
      const Eigen::Vector3d p =
          corner.x() * u + corner.y() * v + static_cast<double>(plane.distance) * normal;
      polygons->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
  }
  data.SetPoints(points);
  data.SetPolys(polygons);
}

}  // namespace

vtkSmartPointer<vtkPolyData> patch_geometry(const Segmentation& scene) {
  const std::vector<Patch>& patches = scene.graph.patches;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(centroids(patches));
  vtkNew<vtkCellArray> vertices;
  for (std::size_t i = 0; i < patches.size(); ++i)
    vertices->InsertNextCell({static_cast<vtkIdType>(i)});
  data->SetVerts(vertices);

  vtkPointData& columns = *data->GetPointData();
  const auto add = [&](const char* name, auto member) {
    columns.AddArray(make_column<vtkFloatArray>(name, patches.size(),
                                                [&](std::size_t i) { return patches[i].*member; }));
  };
  const auto add_count = [&](const char* name, auto member) {
    columns.AddArray(make_column<vtkUnsignedIntArray>(
        name, patches.size(), [&](std::size_t i) { return patches[i].*member; }));
  };
  columns.AddArray(make_vectors<vtkFloatArray>("normal", patches.size(),
                                               [&](std::size_t i) { return patches[i].normal; }));
  columns.AddArray(make_vectors<vtkUnsignedCharArray>(
      "color", patches.size(), [&](std::size_t i) { return patches[i].color; }));
  add("curvature", &Patch::curvature);
  add("area", &Patch::area);
  add("scale", &Patch::scale);
  add_count("point_count", &Patch::point_count);
  add_count("voxel_count", &Patch::voxel_count);
  add_membership(scene, columns);
  columns.AddArray(make_column<vtkFloatArray>(
      "plane_margin", patches.size(), [&](std::size_t i) { return scene.patch_plane[i].margin; }));
  return data;
}

vtkSmartPointer<vtkPolyData> graph_geometry(const Segmentation& scene) {
  const std::vector<Edge>& edges = scene.edges;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(centroids(scene.graph.patches));
  vtkNew<vtkCellArray> lines;
  for (const Edge& edge : edges)
    lines->InsertNextCell(
        {static_cast<vtkIdType>(edge.first), static_cast<vtkIdType>(edge.second)});
  data->SetLines(lines);
  add_membership(scene, *data->GetPointData());

  vtkCellData& columns = *data->GetCellData();
  const auto add = [&]<typename Array>(const char* name, vtkSmartPointer<Array>, auto member) {
    columns.AddArray(
        make_column<Array>(name, edges.size(), [&](std::size_t i) { return edges[i].*member; }));
  };
  using Bytes = vtkSmartPointer<vtkUnsignedCharArray>;
  using Counts = vtkSmartPointer<vtkUnsignedIntArray>;
  using Floats = vtkSmartPointer<vtkFloatArray>;
  add("on", Bytes(), &Edge::on);
  add("rule", Bytes(), &Edge::rule);
  add("border", Counts(), &Edge::border);
  add("normal_angle", Floats(), &Edge::normal_angle);
  add("convexity", Floats(), &Edge::convexity);
  add("singular_angle", Floats(), &Edge::singular_angle);
  add("singular_limit", Floats(), &Edge::singular_limit);
  add("step", Floats(), &Edge::step);
  add("step_limit", Floats(), &Edge::step_limit);
  add("support", Counts(), &Edge::support);
  add("margin", Floats(), &Edge::margin);
  return data;
}

vtkSmartPointer<vtkPolyData> plane_geometry(const Segmentation& scene, const PointCloud& cloud) {
  const std::vector<Hull> hulls = make_hulls(scene, cloud);
  const auto plane_of = [&](std::size_t i) -> const SupportingPlane& {
    return scene.planes[static_cast<std::size_t>(hulls[i].group.first)];
  };
  auto data = vtkSmartPointer<vtkPolyData>::New();
  add_polygons(scene, hulls, *data);

  vtkCellData& columns = *data->GetCellData();
  const auto add = [&]<typename Array>(const char* name, vtkSmartPointer<Array>, auto value) {
    columns.AddArray(make_column<Array>(name, hulls.size(), value));
  };
  using Integers = vtkSmartPointer<vtkIntArray>;
  using Counts = vtkSmartPointer<vtkUnsignedIntArray>;
  using Floats = vtkSmartPointer<vtkFloatArray>;
  add("plane", Integers(), [&](std::size_t i) { return hulls[i].group.first; });
  add("label", Counts(), [&](std::size_t i) { return hulls[i].group.second; });
  add("point_count", Counts(), [&](std::size_t i) { return hulls[i].point_count; });
  add("area", Floats(), [&](std::size_t i) { return polygon_area(hulls[i].corners); });
  columns.AddArray(make_vectors<vtkFloatArray>(
      "normal", hulls.size(), [&](std::size_t i) { return plane_of(i).plane.normal; }));
  add("distance", Floats(), [&](std::size_t i) { return plane_of(i).plane.distance; });
  add("rms", Floats(), [&](std::size_t i) { return plane_of(i).rms; });
  return data;
}

}  // namespace planescope::draw
