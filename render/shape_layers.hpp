// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "camera.hpp"
#include "image.hpp"
#include "point_layer.hpp"
#include "scene_data.hpp"
#include "viewpoint.hpp"

/// \file What is drawn over the points: planes and the graph. All of it is moved towards the camera
/// by a little, along the lines of sight, so that it is read and not buried in the points' noise:
/// that does not change where it is seen.
namespace planescope::draw {

/// How lines are drawn.
struct Pen {
  double width = 1;           ///< [pixel of the picture that is drawn] of a thin line
  double picture_height = 1;  ///< [pixel] of the picture that is drawn
};

using Actors = std::vector<vtkSmartPointer<vtkActor>>;

/// `p` moved towards the camera by `distance` [m], at most half the way.
Eigen::Vector3d lifted(const Eigen::Vector3d& p, const Eigen::Vector3d& camera, double distance);

/// Each hull translucent in its plane's colour, with an outline in a darker one.
Actors plane_layer(const SceneData& scene, const SceneColors& colors, const Cutaway& cut,
                   const Camera& camera, const Pen& pen);

/// Patch centroids as dots, ON edges thin, dark and solid, OFF edges thick, bright and
/// dashed (as geometry: OpenGL's core profile has no stipple).
Actors graph_layer(const SceneData& scene, const Cutaway& cut, const Camera& camera,
                   const Pen& pen);

/// Numbers of ON and OFF edges, as a legend says them.
struct EdgeCounts {
  std::size_t on = 0, off = 0;
};
EdgeCounts count_edges(const SceneData& scene);

}  // namespace planescope::draw
