// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "planescope/result.hpp"

/// \file All that is drawn, in one shape, whether it comes from memory or from a result folder.
namespace planescope::draw {

/// A scene, ready to be drawn. The geometry's arrays are those of geometry.hpp.
struct SceneData {
  Result result;                         ///< points with their labels, planes, segments
  vtkSmartPointer<vtkPolyData> patches;  ///< patch_geometry()
  vtkSmartPointer<vtkPolyData> graph;    ///< graph_geometry()
  vtkSmartPointer<vtkPolyData> planes;   ///< plane_geometry()
};

/// From a segmentation in memory.
SceneData scene_data(const Segmentation& scene, const PointCloud& cloud,
                     const InputInfo& input = {});

/// From a result folder, nothing recomputed.
/// \throws Error{Kind::Input} a file is missing or malformed, or the files do not belong together.
SceneData scene_data(const std::filesystem::path& folder);

/// patches.vtp, graph.vtp and planes.vtp of a folder, for a result that was read from there.
/// \throws Error{Kind::Input} as above.
SceneData add_geometry(Result result, const std::filesystem::path& folder);

/// graph.vtp of a folder alone. \throws Error{Kind::Input} as above.
vtkSmartPointer<vtkPolyData> read_graph(const Result& result, const std::filesystem::path& folder);

}  // namespace planescope::draw
