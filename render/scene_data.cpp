// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene_data.hpp"

#include <future>
#include <string>
#include <utility>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "geometry.hpp"
#include "geometry_files.hpp"
#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

using Columns = VtpContract::Columns;

/// Values of one column must lie in [low, high].
void check_range(const std::filesystem::path& file, vtkDataSetAttributes& columns, const char* name,
                 double low, double high) {
  vtkDataArray& values = *columns.GetArray(name);
  for (vtkIdType i = 0; i < values.GetNumberOfTuples(); ++i) {
    const double value = values.GetTuple1(i);
    if (!(value >= low && value <= high)) {
      throw Error(Error::Kind::Input,
                  file.string() + ": `" + name + "` of entry " + std::to_string(i) + " is " +
                      std::to_string(value) + ", expected " + std::to_string(low) + " to " +
                      std::to_string(high) + "; segment the scene again to make the folder anew");
    }
  }
}

}  // namespace

SceneData scene_data(const Segmentation& scene, const PointCloud& cloud, const InputInfo& input) {
  return {make_result(scene, cloud, input), patch_geometry(scene), graph_geometry(scene),
          plane_geometry(scene, cloud)};
}

SceneData scene_data(const std::filesystem::path& folder) {
  return add_geometry(load_result(folder), folder);
}

vtkSmartPointer<vtkPolyData> read_graph(const Result& result, const std::filesystem::path& folder) {
  const auto file = folder / "graph.vtp";
  auto graph = read_vtp(file, result.cloud.origin,
                        {Columns::OfCells,
                         {{"on", 1}, {"rule", 1}, {"margin", 1}},
                         static_cast<vtkIdType>(result.patch_count)});
  check_range(file, *graph->GetCellData(), "rule", 0, kEdgeRuleCount - 1);
  return graph;
}

SceneData add_geometry(Result result, const std::filesystem::path& folder) {
  const auto patch_count = static_cast<vtkIdType>(result.patch_count);
  const double last_plane = static_cast<double>(result.planes.size()) - 1;
  const auto last_label = static_cast<double>(result.segments.size());
  const Eigen::Vector3d& origin = result.cloud.origin;

  const auto read = [&](const char* name, const VtpContract& contract) {
    check_file(result, folder, name);
    return read_vtp(folder / name, origin, contract);
  };
  // Two large files at once.
  auto graph = std::async(std::launch::async, [&] {
    check_file(result, folder, "graph.vtp");
    return read_graph(result, folder);
  });
  SceneData data;
  data.patches = read("patches.vtp", {Columns::OfPoints,
                                      {{"normal", 3},
                                       {"curvature", 1},
                                       {"area", 1},
                                       {"point_count", 1},
                                       {"plane", 1},
                                       {"label", 1}},
                                      patch_count});
  data.graph = graph.get();
  // A hull has no more corners than its points.
  data.planes =
      read("planes.vtp", {Columns::OfCells,
                          {{"plane", 1}, {"label", 1}, {"normal", 3}, {"distance", 1}, {"rms", 1}},
                          -1,
                          static_cast<vtkIdType>(result.cloud.size())});
  const auto patches = folder / "patches.vtp", planes = folder / "planes.vtp";
  check_range(patches, *data.patches->GetPointData(), "plane", kNone, last_plane);
  check_range(patches, *data.patches->GetPointData(), "label", 0, last_label);
  check_range(planes, *data.planes->GetCellData(), "plane", 0, last_plane);
  check_range(planes, *data.planes->GetCellData(), "label", 1, last_label);
  data.result = std::move(result);
  return data;
}

}  // namespace planescope::draw
