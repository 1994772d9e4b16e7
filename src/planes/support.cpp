// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/support.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

namespace planescope {
namespace {

struct Members {
  double area = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  std::uint32_t patches = 0, points = 0;

  void add(const Patch& patch) {
    const Eigen::Vector3d c = patch.centroid.cast<double>();
    const double w = patch.area;
    area += w;
    first += w * c;
    second += w * c * c.transpose();
    ++patches;
    points += patch.point_count;
  }
};

// Least squares through the members' centroids; the normal keeps the side of `old`. Fewer than
// three members keep `old`.
Plane fit(const Members& members, const Plane& old) {
  if (members.patches < 3) return old;
  const Eigen::Vector3d mean = members.first / members.area;
  const Eigen::Matrix3d covariance = members.second / members.area - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  // Members on a line leave the plane free to turn about it: the old normal knows better.
  if (solver.eigenvalues()[1] < 10 * std::max(solver.eigenvalues()[0], 1e-12)) return old;
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  if (normal.dot(old.normal.cast<double>()) < 0) normal = -normal;
  return {normal.cast<float>(), static_cast<float>(normal.dot(mean))};
}

// |U - 2| / 2 for the patch's plane or, on none, for the plane that it came nearest to.
float margin(const Patch& patch, std::int32_t plane, std::span<const SupportingPlane> planes,
             const PlaneOptions& options) {
  const auto cost = [&](const Plane& p) {
    return std::abs(p.signed_distance(patch.centroid)) /
           (static_cast<float>(options.sigma) * patch.scale);
  };
  if (plane != kNone) {
    return std::clamp((2 - cost(planes[static_cast<std::size_t>(plane)].plane)) / 2, 0.0f, 1.0f);
  }
  float nearest = 4;  // from there on the margin is 1
  for (const SupportingPlane& candidate : planes) {
    const float cosine = std::abs(candidate.plane.normal.dot(patch.normal));
    if (candidate.role == PlaneRole::Support && cosine >= static_cast<float>(options.normal_gate))
      nearest = std::min(nearest, cost(candidate.plane));
  }
  return std::clamp((nearest - 2) / 2, 0.0f, 1.0f);
}

}  // namespace

Support refit_planes(const PatchGraph& graph, const PlaneSelection& selection,
                     const std::vector<std::int32_t>& assignment) {
  const std::size_t count = selection.selected.size();
  std::vector<Members> members(count);
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    if (assignment[i] != kNone)
      members[static_cast<std::size_t>(assignment[i])].add(graph.patches[i]);
  }
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t s) { return members[s].patches == 0; });
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return members[a].area > members[b].area; });

  Support support;
  std::vector<std::int32_t> renamed(count, kNone);
  for (const std::size_t s : order) {
    renamed[s] = static_cast<std::int32_t>(support.planes.size());
    SupportingPlane plane;
    plane.hypothesis = selection.selected[s];
    plane.plane = fit(members[s], selection.hypotheses[plane.hypothesis].plane);
    plane.patch_count = members[s].patches;
    plane.point_count = members[s].points;
    plane.area = static_cast<float>(members[s].area);
    support.planes.push_back(plane);
  }
  std::vector<double> squares(support.planes.size(), 0.0);
  support.patch_plane.resize(assignment.size());
  for (std::size_t i = 0; i < assignment.size(); ++i) {
    if (assignment[i] == kNone) continue;
    const std::int32_t on = renamed[static_cast<std::size_t>(assignment[i])];
    support.patch_plane[i].plane = on;
    const auto p = static_cast<std::size_t>(on);
    const double r = support.planes[p].plane.signed_distance(graph.patches[i].centroid);
    squares[p] += double(graph.patches[i].area) * r * r;
  }
  for (std::size_t p = 0; p < squares.size(); ++p) {
    support.planes[p].rms =
        static_cast<float>(std::sqrt(squares[p] / double(support.planes[p].area)));
  }
  return support;
}

void measure_margins(std::vector<PatchPlane>& patch_plane, std::span<const Patch> patches,
                     std::span<const SupportingPlane> planes, const PlaneOptions& options) {
  for (std::size_t i = 0; i < patch_plane.size(); ++i) {
    patch_plane[i].margin = margin(patches[i], patch_plane[i].plane, planes, options);
  }
}

}  // namespace planescope
