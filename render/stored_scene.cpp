// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/stored_scene.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "planescope/error.hpp"
#include "scene_data.hpp"
#include "vtk_arrays.hpp"

/// \file load_scene(): the geometry's arrays, back in the engine's own types.
namespace planescope {
namespace {

using draw::SceneData;

[[noreturn]] void refuse(const char* file, const std::string& what) {
  throw Error(Error::Kind::Input, std::string(file) + ": " + what +
                                      "; segment the scene again to make the folder anew");
}

/// The arrays of one file; every value is finite, and there is one tuple an entry.
class Columns {
 public:
  Columns(const char* file, vtkDataSetAttributes& data, vtkIdType rows)
      : file_(file), data_(data), rows_(rows) {}

  vtkDataArray& operator()(const char* name, int components = 1) const {
    vtkDataArray* array = data_.GetArray(name);
    if (array == nullptr || array->GetNumberOfTuples() != rows_ ||
        array->GetNumberOfComponents() != components)
      refuse(file_, "has no whole array `" + std::string(name) + "`");
    for (int c = 0; c < components; ++c) {
      const double* range = array->GetRange(c);
      const bool empty = rows_ == 0;
      if (!empty && !(std::isfinite(range[0]) && std::isfinite(range[1])))
        refuse(file_, std::string(name) + " has values that are not finite");
    }
    return *array;
  }

 private:
  const char* file_;
  vtkDataSetAttributes& data_;
  vtkIdType rows_;
};

Eigen::Vector3f vector(vtkDataArray& array, vtkIdType i) {
  Eigen::Vector3d v;
  array.GetTuple(i, v.data());
  return v.cast<float>();
}

template <class Value>
Value value(vtkDataArray& array, vtkIdType i) {
  return static_cast<Value>(array.GetTuple1(i));
}

void read_patches(const SceneData& data, Segmentation& scene) {
  const vtkIdType count = data.patches->GetNumberOfPoints();
  const Columns column("patches.vtp", *data.patches->GetPointData(), count);
  vtkDataArray& own = column("own_normal", 3);
  vtkDataArray &normal = column("normal", 3), &color = column("color", 3);
  vtkDataArray &curvature = column("curvature"), &area = column("area"), &scale = column("scale");
  vtkDataArray &points = column("point_count"), &voxels = column("voxel_count");
  vtkDataArray &plane = column("plane"), &margin = column("plane_margin"), &label = column("label");
  for (vtkIdType i = 0; i < count; ++i) {
    Patch patch;
    patch.centroid = draw::point(*data.patches, i);
    patch.normal = vector(normal, i);
    patch.own_normal = vector(own, i);
    patch.color = vector(color, i);
    patch.curvature = value<float>(curvature, i);
    patch.area = value<float>(area, i);
    patch.scale = value<float>(scale, i);
    patch.point_count = value<std::uint32_t>(points, i);
    patch.voxel_count = value<std::uint32_t>(voxels, i);
    if (!(patch.scale > 0)) refuse("patches.vtp", "`scale` has values that are not positive");
    scene.graph.patches.push_back(patch);
    const auto on = value<std::int32_t>(plane, i);
    const bool face =
        on != kNone && data.result.planes[static_cast<std::size_t>(on)].role == PlaneRole::Face;
    scene.patch_plane.push_back({face ? kNone : on, value<float>(margin, i)});
    scene.patch_face.push_back(face ? on : kNone);
    scene.segments.patch_label.push_back(value<std::uint32_t>(label, i));
  }
}

/// Each pair once, in order: what every walk over the graph takes for granted.
void check_order(const Edge& edge, const std::vector<Edge>& before) {
  const bool ordered = before.empty() || std::pair(before.back().first, before.back().second) <
                                             std::pair(edge.first, edge.second);
  if (edge.first >= edge.second || !ordered)
    refuse("graph.vtp", "edge " + std::to_string(before.size()) + " is not where it should be");
}

void read_edges(const SceneData& data, Segmentation& scene) {
  const vtkIdType count = data.graph->GetNumberOfCells();
  const Columns column("graph.vtp", *data.graph->GetCellData(), count);
  vtkDataArray &on = column("on"), &rule = column("rule"), &border = column("border");
  vtkDataArray &angle = column("normal_angle"), &convexity = column("convexity");
  vtkDataArray &singular = column("singular_angle"), &singular_limit = column("singular_limit");
  vtkDataArray &step = column("step"), &step_limit = column("step_limit");
  vtkDataArray &support = column("support"), &margin = column("margin");
  for (vtkIdType i = 0; i < count; ++i) {
    const auto ends = draw::corners(*data.graph->GetLines(), i);
    if (ends.size() != 2) refuse("graph.vtp", "an edge does not have two ends");
    Edge edge;
    edge.first = static_cast<std::uint32_t>(ends[0]);
    edge.second = static_cast<std::uint32_t>(ends[1]);
    check_order(edge, scene.edges);
    edge.border = value<std::uint32_t>(border, i);
    edge.on = on.GetTuple1(i) != 0;
    edge.rule = static_cast<EdgeRule>(value<std::uint8_t>(rule, i));
    edge.normal_angle = value<float>(angle, i);
    edge.convexity = value<float>(convexity, i);
    edge.singular_angle = value<float>(singular, i);
    edge.singular_limit = value<float>(singular_limit, i);
    edge.step = value<float>(step, i);
    edge.step_limit = value<float>(step_limit, i);
    const auto& patches = scene.graph.patches;
    const float length = (patches[edge.first].centroid - patches[edge.second].centroid).norm();
    edge.facing = -0.5f * edge.convexity * length;
    edge.support = value<std::uint32_t>(support, i);
    edge.margin = value<float>(margin, i);
    scene.edges.push_back(edge);
    scene.graph.adjacency.push_back({edge.first, edge.second, edge.border});
  }
}

void check_counts(const Result& result, const std::vector<Edge>& edges) {
  const auto counts = count_rules(edges);
  for (std::size_t rule = 0; rule < kEdgeRuleCount; ++rule) {
    if (counts[rule] != result.rule_counts[rule])
      refuse("graph.vtp", "has " + std::to_string(counts[rule]) + " edges by rule `" +
                              std::string(name(static_cast<EdgeRule>(rule))) +
                              "`, result.json says " + std::to_string(result.rule_counts[rule]));
  }
}

}  // namespace

StoredScene load_scene(const std::filesystem::path& folder) {
  SceneData data = draw::scene_data(folder);
  StoredScene stored;
  Segmentation& scene = stored.scene;
  read_patches(data, scene);
  read_edges(data, scene);
  Result& result = data.result;
  check_counts(result, scene.edges);
  scene.method = std::move(result.method);
  scene.options = result.options;
  scene.graph.voxel_size = static_cast<float>(result.voxel_size);
  scene.graph.patch_size = static_cast<float>(result.patch_size);
  scene.graph.point_patch = std::move(result.point_patch);
  scene.selection = std::move(result.selection);
  scene.planes = std::move(result.planes);
  scene.segments.segments = std::move(result.segments);
  scene.point_label = std::move(result.point_label);
  scene.point_plane = std::move(result.point_plane);
  stored.cloud = std::move(result.cloud);
  stored.input = {std::move(result.input_name), std::move(result.input_hash)};
  return stored;
}

}  // namespace planescope
