// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patch_report.hpp"

#include <cmath>
#include <limits>

namespace planescope {
namespace {

/// U of eq. (10) without its weight: distance over sigma of this patch.
double distance_cost(const Patch& patch, const Plane& plane, double sigma) {
  return std::abs(static_cast<double>(plane.signed_distance(patch.centroid))) /
         (sigma * static_cast<double>(patch.scale));
}

}  // namespace

PatchReport report_patch(const Segmentation& scene, std::uint32_t id) {
  PatchReport r;
  r.id = id;
  r.patch = scene.graph.patches[id];
  r.segment = scene.segments.patch_label[id];
  r.plane = scene.patch_plane[id].plane;
  r.margin = scene.patch_plane[id].margin;
  r.nearest = r.plane;
  const PlaneOptions& options = scene.options.planes;
  r.distance_limit = 2 * options.sigma * static_cast<double>(r.patch.scale);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < scene.planes.size() && r.plane == kNone; ++p) {
    if (scene.planes[p].role != PlaneRole::Support) continue;
    const Plane& plane = scene.planes[p].plane;
    const double cost = distance_cost(r.patch, plane, options.sigma);
    const double cosine = std::abs(static_cast<double>(plane.normal.dot(r.patch.normal)));
    if (cosine < options.normal_gate || cost >= least) continue;
    least = cost;
    r.nearest = static_cast<std::int32_t>(p);
  }
  if (r.nearest == kNone) return r;
  const Plane& plane = scene.planes[static_cast<std::size_t>(r.nearest)].plane;
  r.distance = std::abs(static_cast<double>(plane.signed_distance(r.patch.centroid)));
  r.normal_cosine = std::abs(static_cast<double>(plane.normal.dot(r.patch.normal)));
  return r;
}

}  // namespace planescope
