// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "planescope/pipeline.hpp"

namespace planescope {
namespace {

std::string format(const char* pattern, double a, double b = 0) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), pattern, a, b);
  return text.data();
}

std::string by_planes(const Edge& edge, const std::vector<PatchPlane>& patch_plane) {
  const std::int32_t a = patch_plane[edge.first].plane, b = patch_plane[edge.second].plane;
  switch (edge.rule) {
    case EdgeRule::SamePlane:
      return "both patches lie on plane " + std::to_string(a);
    case EdgeRule::DifferentPlanes:
      return "the patches lie on planes " + std::to_string(a) + " and " + std::to_string(b);
    default:
      return "one patch lies on plane " + std::to_string(std::max(a, b)) + ", the other on none";
  }
}

std::string by_geometry(const Edge& edge, const EdgeOptions& options) {
  switch (edge.rule) {
    case EdgeRule::Convex:
      return format("the surface bends away from the viewer (convexity %.3f >= 0)", edge.convexity);
    case EdgeRule::NearlyFlat:
      return format("concave, but the normals differ by %.1f deg only (tolerance %.1f deg)",
                    edge.normal_angle, options.concavity_tolerance);
    case EdgeRule::Concave:
      return format("concave (convexity %.3f < 0), ", edge.convexity) +
             format("and the normals differ by %.1f deg (tolerance %.1f deg)", edge.normal_angle,
                    options.concavity_tolerance);
    case EdgeRule::Singular:
      return format(
          "the patches meet in one place only: they lie at %.1f deg to the fold, less than %.1f "
          "deg",
          edge.singular_angle, edge.singular_limit);
    case EdgeRule::Step:
      return format("a step of %.4f m, more than the %.4f m that the normals explain", edge.step,
                    edge.step_limit);
    default:
      return "convex, but no common neighbour is joined to both (extended convexity)";
  }
}

}  // namespace

std::string explain(const Segmentation& scene, const Edge& edge) {
  const bool planes = edge.rule == EdgeRule::SamePlane || edge.rule == EdgeRule::DifferentPlanes ||
                      edge.rule == EdgeRule::PlaneBoundary;
  return "edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second) + " is " +
         (edge.on ? "ON" : "OFF") + " (" + std::string(name(edge.rule)) + ", margin " +
         format("%.2f", edge.margin) + "): " +
         (planes ? by_planes(edge, scene.patch_plane) : by_geometry(edge, scene.options.edges)) +
         ".";
}

}  // namespace planescope
