// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/object_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planes/energy.hpp"
#include "planes/face_pieces.hpp"
#include "planes/hypotheses.hpp"
#include "planes/support.hpp"

namespace planescope {
namespace {

constexpr double kFewestPatches = 20;  // of fewer, a cylinder's side is a plane too
constexpr double kFrameWeight = 4;     // a face pays as for this many supporting planes

// The patches that lie on no supporting plane, with the edges among them.
struct FreePatches {
  PatchGraph graph;
  std::vector<std::uint32_t> ids;  // of its patches in the whole graph
};

FreePatches find_free_patches(const PatchGraph& graph, const std::vector<PatchPlane>& patch_plane) {
  FreePatches part;
  std::vector<std::uint32_t> renamed(graph.patches.size());
  const auto is_free = [&](std::uint32_t i) { return patch_plane[i].plane == kNone; };
  for (std::uint32_t i = 0; i < graph.patches.size(); ++i) {
    if (!is_free(i)) continue;
    renamed[i] = static_cast<std::uint32_t>(part.ids.size());
    part.ids.push_back(i);
    part.graph.patches.push_back(graph.patches[i]);
  }
  for (const Adjacency& pair : graph.adjacency) {
    if (!is_free(pair.first) || !is_free(pair.second)) continue;
    part.graph.adjacency.push_back({renamed[pair.first], renamed[pair.second], pair.border});
  }
  return part;
}

PlaneOptions face_options(const PlaneOptions& options) {
  PlaneOptions small = options;
  small.min_area = options.face_area;
  small.sigma = face_sigma(options.sigma);
  small.weight_angle = 0;  // among faces; what they pay for the room is in D
  return small;
}

// Eq. (6)'s angle term with each of the planes that stand, as a share of their mean.
std::vector<double> angle_costs(const Plane& plane, const std::vector<SupportingPlane>& standing,
                                const PlaneOptions& options) {
  std::vector<double> costs;
  for (const SupportingPlane& other : standing) {
    const double deviation = manhattan_deviation(plane.normal, other.plane.normal);
    costs.push_back(kFrameWeight * options.weight_angle *
                    (1 - std::exp(-deviation / options.alpha)) /
                    static_cast<double>(standing.size()));
  }
  return costs;
}

double face_lambda(const std::vector<Patch>& patches, const PlaneOptions& options) {
  return std::max(kFewestPatches, support_threshold(patches, options.face_area));
}

std::vector<std::uint8_t> fresh_of(const FreePatches& part, const HeldPlanes& held) {
  std::vector<std::uint8_t> fresh;
  for (const std::uint32_t id : part.ids) fresh.push_back(held.fresh[id]);
  return fresh;
}

}  // namespace

// Steps of furniture are smaller than a room's.
double face_sigma(double sigma) { return 0.42 * sigma; }

std::vector<HeldPlane> select_object_faces(const PatchGraph& graph,
                                           const std::vector<SupportingPlane>& supporting,
                                           const std::vector<PatchPlane>& patch_plane,
                                           const PlaneOptions& options, const HeldPlanes* held) {
  if (options.face_area <= 0) return {};
  const FreePatches part = find_free_patches(graph, patch_plane);
  if (part.ids.empty()) return {};
  const double lambda = face_lambda(graph.patches, options);
  const PlaneOptions small = face_options(options);
  const PatchIndex index(part.graph.patches);
  const Hypotheses found =
      held == nullptr ? propose_hypotheses(index, small, lambda)
                      : renew_hypotheses(index, small, lambda, held->faces, fresh_of(part, *held));
  SelectionEnergy energy =
      selection_energy(found.kept, pair_terms(found.kept, index, part.graph, small), lambda);
  for (std::size_t m = 0; m < energy.size(); ++m) {
    for (const double cost : angle_costs(found.kept[m].plane, supporting, options)) {
      energy.unary[m] += cost;
    }
  }
  const std::vector<bool> x = minimise_selection(energy, small.solver, small.tabu_steps);
  std::vector<HeldPlane> faces;
  for (std::size_t m = 0; m < x.size(); ++m) faces.push_back({found.kept[m].plane, x[m]});
  return faces;
}

ObjectFaces place_object_faces(const PatchGraph& graph, const std::vector<PatchPlane>& patch_plane,
                               const std::vector<HeldPlane>& faces, const PlaneOptions& options) {
  ObjectFaces result;
  result.patch_face.assign(graph.patches.size(), kNone);
  std::vector<Plane> planes;
  for (const HeldPlane& h : faces) {
    if (h.selected) planes.push_back(h.plane);
  }
  const FreePatches part = find_free_patches(graph, patch_plane);
  if (part.ids.empty()) return result;
  const PlaneOptions small = face_options(options);
  Support support = refit_pieces(part.graph, planes, assign_planes(part.graph, planes, small),
                                 small, face_lambda(graph.patches, options));
  for (SupportingPlane& face : support.planes) {
    face.role = PlaneRole::Face;
    face.hypothesis = 0;
  }
  for (std::size_t i = 0; i < part.ids.size(); ++i) {
    result.patch_face[part.ids[i]] = support.patch_plane[i].plane;
  }
  result.planes = std::move(support.planes);
  return result;
}

FaceTerms face_terms(const Plane& face, const std::vector<Patch>& patches,
                     const std::vector<SupportingPlane>& supporting,
                     const std::vector<PatchPlane>& patch_plane, const PlaneOptions& options) {
  std::vector<Patch> free;
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    if (patch_plane[i].plane != kNone) continue;
    ids.push_back(i);
    free.push_back(patches[i]);
    free.back().normal = patches[i].own_normal;
  }
  const PatchIndex index(free);
  const PlaneOptions small = face_options(options);
  FaceTerms terms;
  terms.lambda = face_lambda(patches, options);
  const Bits inliers = index.inliers({.plane = face,
                                      .half_width = static_cast<float>(small.sigma),
                                      .gate = static_cast<float>(small.normal_gate)});
  for_each(inliers, [&](std::size_t i) { terms.inliers.push_back(ids[index.patch(i)]); });
  std::ranges::sort(terms.inliers);
  terms.data_cost = data_cost(static_cast<double>(terms.inliers.size()), terms.lambda);
  terms.angle_cost = angle_costs(face, supporting, options);
  return terms;
}

void steady_normals(std::vector<Patch>& patches, std::span<const SupportingPlane> planes,
                    std::span<const std::int32_t> patch_face) {
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patch_face[i] == kNone) continue;
    const Eigen::Vector3f& n = planes[static_cast<std::size_t>(patch_face[i])].plane.normal;
    patches[i].normal = n.dot(patches[i].normal) < 0 ? Eigen::Vector3f(-n) : n;
  }
}

}  // namespace planescope
