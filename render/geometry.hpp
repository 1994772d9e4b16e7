// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "planescope/pipeline.hpp"

/// \file A segmentation as VTK's data: what the drawing reads, and what the .vtp files hold.
/// Coordinates are metres relative to the cloud's origin.
namespace planescope::draw {

/// The patches as vertices at their centroids. Point data: `normal` (3), `own_normal` (3), `color`
/// (3 bytes), `curvature`, `area`, `point_count`, `voxel_count`, `plane` (-1: none), `label`,
/// `plane_margin`.
vtkSmartPointer<vtkPolyData> patch_geometry(const Segmentation& scene);

/// The graph: points are the patches' centroids (point data `plane`, `label`), lines the edges in
/// the order of Segmentation::edges. Cell data: `on` (0, 1), `rule` (EdgeRule), `border`,
/// `normal_angle`, `convexity`, `singular_angle`, `singular_limit`, `step`, `step_limit`,
/// `support`, `margin`.
vtkSmartPointer<vtkPolyData> graph_geometry(const Segmentation& scene);

/// One polygon for every pair of a supporting plane and a segment that lies on it: the convex hull
/// of their common points, projected onto the plane; ordered by plane, then label. Pairs whose
/// points lie on a line are left out. Cell data: `plane`, `label`, `point_count`, `area` [m^2] of
/// the hull, `normal` (3), `distance` [m], `rms` [m].
vtkSmartPointer<vtkPolyData> plane_geometry(const Segmentation& scene, const PointCloud& cloud);

}  // namespace planescope::draw
