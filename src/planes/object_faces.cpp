// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/object_faces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "planes/energy.hpp"
#include "planes/hypotheses.hpp"
#include "planes/support.hpp"

namespace planescope {
namespace {

constexpr double kFewestPatches = 20;  // of fewer, a cylinder's side is a plane too
constexpr double kFrameWeight = 4;     // a face pays as for this many supporting planes
constexpr double kFaceSigma = 0.45;    // of sigma: the steps of furniture are smaller than a room's

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
  small.sigma = kFaceSigma * options.sigma;
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

PlaneSelection select_faces(const FreePatches& part, double lambda,
                            const std::vector<SupportingPlane>& standing,
                            const PlaneOptions& options, const HeldPlanes* held) {
  const PlaneOptions small = face_options(options);
  const PatchIndex index(part.graph.patches);
  const Hypotheses found =
      held == nullptr ? propose_hypotheses(index, small, lambda)
                      : renew_hypotheses(index, small, lambda, held->faces, fresh_of(part, *held));
  SelectionEnergy energy =
      selection_energy(found.kept, pair_terms(found.kept, index, part.graph, small), lambda);
  for (std::size_t m = 0; m < energy.size(); ++m) {
    for (const double cost : angle_costs(found.kept[m].plane, standing, options)) {
      energy.unary[m] += cost;
    }
  }
  const std::vector<bool> x = minimise_selection(energy, small.solver, small.tabu_steps);
  PlaneSelection selection;
  for (std::uint32_t m = 0; m < x.size(); ++m) {
    selection.hypotheses.push_back({.plane = found.kept[m].plane, .selected = x[m]});
    if (x[m]) selection.selected.push_back(m);
  }
  return selection;
}

// The direction nearest to `normal` that is parallel to a standing plane, or orthogonal to one or
// two, where it deviates from them by less than `tolerance` degrees; else `normal` itself.
Eigen::Vector3f align(const Eigen::Vector3f& normal, const std::vector<SupportingPlane>& standing,
                      double tolerance) {
  const float parallel = std::cos(static_cast<float>(tolerance * std::numbers::pi / 180));
  const float orthogonal = std::sin(static_cast<float>(tolerance * std::numbers::pi / 180));
  const auto along = [&](const Eigen::Vector3f& direction) {
    return direction.dot(normal) < 0 ? Eigen::Vector3f(-direction) : direction;
  };
  for (const SupportingPlane& s : standing) {
    if (std::abs(s.plane.normal.dot(normal)) > parallel) return along(s.plane.normal);
  }
  const Eigen::Vector3f* first = nullptr;
  for (const SupportingPlane& s : standing) {
    const Eigen::Vector3f& n = s.plane.normal;
    if (std::abs(n.dot(normal)) > orthogonal) continue;
    if (first == nullptr) {
      first = &n;
    } else if (std::abs(first->dot(n)) < 0.5f) {
      return along(first->cross(n).normalized());
    }
  }
  if (first == nullptr) return normal;
  return (normal - first->dot(normal) * *first).normalized();
}

// Weighted mean and spread of a face's patches along a direction.
struct Spread {
  double area = 0, first = 0, second = 0;
  void add(const Patch& patch, const Eigen::Vector3f& normal) {
    const double r = normal.cast<double>().dot(patch.centroid.cast<double>());
    area += double(patch.area);
    first += double(patch.area) * r;
    second += double(patch.area) * r * r;
  }
  double mean() const { return first / area; }
  double rms() const { return std::sqrt(std::max(0.0, second / area - mean() * mean())); }
};

// Faces that fit as well, within their noise, in the directions of the supporting planes, take
// these.
void align_faces(const FreePatches& part, Support& faces,
                 const std::vector<SupportingPlane>& standing, const PlaneOptions& options) {
  std::vector<Eigen::Vector3f> normals;
  for (const SupportingPlane& face : faces.planes) {
    normals.push_back(align(face.plane.normal, standing, options.alpha / 2));
  }
  std::vector<Spread> spreads(normals.size());
  for (std::size_t i = 0; i < part.ids.size(); ++i) {
    const std::int32_t f = faces.patch_plane[i].plane;
    if (f == kNone) continue;
    spreads[static_cast<std::size_t>(f)].add(part.graph.patches[i],
                                             normals[static_cast<std::size_t>(f)]);
  }
  for (std::size_t f = 0; f < normals.size(); ++f) {
    SupportingPlane& face = faces.planes[f];
    const double allowed =
        std::max(1.5 * double(face.rms), 0.5 * face_options(options).sigma);  // 1.5: same noise
    if (!(spreads[f].rms() <= allowed)) continue;
    face.plane = {normals[f], static_cast<float>(spreads[f].mean())};
    face.rms = static_cast<float>(spreads[f].rms());
  }
}

}  // namespace

ObjectFaces find_object_faces(const PatchGraph& graph,
                              const std::vector<SupportingPlane>& supporting,
                              const std::vector<PatchPlane>& patch_plane,
                              const PlaneOptions& options, const HeldPlanes* held) {
  ObjectFaces result;
  result.patch_face.assign(graph.patches.size(), kNone);
  if (options.face_area <= 0) return result;
  const FreePatches part = find_free_patches(graph, patch_plane);
  if (part.ids.empty()) return result;
  const PlaneSelection selection =
      select_faces(part, face_lambda(graph.patches, options), supporting, options, held);
  std::vector<Plane> planes;
  for (const std::uint32_t s : selection.selected) planes.push_back(selection.hypotheses[s].plane);
  const PlaneOptions small = face_options(options);
  Support faces =
      refit_planes(part.graph, selection, assign_planes(part.graph, planes, small), small);
  align_faces(part, faces, supporting, options);
  for (SupportingPlane& face : faces.planes) face.role = PlaneRole::Face;
  for (std::size_t i = 0; i < part.ids.size(); ++i) {
    result.patch_face[part.ids[i]] = faces.patch_plane[i].plane;
  }
  result.planes = std::move(faces.planes);
  for (const PlaneHypothesis& h : selection.hypotheses) {
    result.hypotheses.push_back({h.plane, h.selected});
  }
  return result;
}

FaceTerms face_terms(const Plane& face, const PatchGraph& graph,
                     const std::vector<SupportingPlane>& supporting,
                     const std::vector<PatchPlane>& patch_plane, const PlaneOptions& options) {
  const FreePatches part = find_free_patches(graph, patch_plane);
  const PatchIndex index(part.graph.patches);
  const PlaneOptions small = face_options(options);
  FaceTerms terms;
  terms.lambda = face_lambda(graph.patches, options);
  const Bits inliers = index.inliers({.plane = face,
                                      .half_width = static_cast<float>(small.sigma),
                                      .gate = static_cast<float>(small.normal_gate)});
  for_each(inliers, [&](std::size_t i) { terms.inliers.push_back(part.ids[index.patch(i)]); });
  std::ranges::sort(terms.inliers);
  terms.data_cost = data_cost(terms.inliers.size(), terms.lambda);
  terms.angle_cost = angle_costs(face, supporting, options);
  return terms;
}

void steady_normals(std::vector<Patch>& patches, const ObjectFaces& faces) {
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (faces.patch_face[i] == kNone) continue;
    const Eigen::Vector3f& n =
        faces.planes[static_cast<std::size_t>(faces.patch_face[i])].plane.normal;
    patches[i].normal = n.dot(patches[i].normal) < 0 ? Eigen::Vector3f(-n) : n;
  }
}

}  // namespace planescope
