// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/explain_planes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "patch_report.hpp"
#include "planes/energy.hpp"
#include "planes/object_faces.hpp"
#include "planes/plane_search.hpp"
#include "planescope/error.hpp"
#include "what_if.hpp"

namespace planescope {
namespace {

constexpr double kNothing = 1e-6;  // pairs that cost less are not worth a line

/// The hypotheses of a scene with their inliers again.
std::vector<Hypothesis> with_inliers(const PatchIndex& index, const PlaneSelection& selection,
                                     const PlaneOptions& options) {
  std::vector<Hypothesis> all;
  for (const PlaneHypothesis& h : selection.hypotheses) {
    all.push_back({h.plane, h.inlier_count,
                   index.inliers({.plane = h.plane,
                                  .half_width = static_cast<float>(options.sigma),
                                  .gate = static_cast<float>(options.normal_gate)})});
  }
  return all;
}

/// The plane that most of these patches lie on in a trial, if that is most of them all. A face is
/// no successor to a supporting plane.
std::int32_t successor(const Trial& trial, const std::vector<std::uint32_t>& patches,
                       bool with_faces) {
  std::map<std::int32_t, std::size_t> counts;
  for (const std::uint32_t p : patches) {
    const std::int32_t plane = trial.patch_plane[p].plane;
    ++counts[plane == kNone && with_faces ? trial.patch_face[p] : plane];
  }
  for (const auto& [plane, count] : counts)
    if (plane != kNone && 2 * count > patches.size()) return plane;
  return kNone;
}

}  // namespace

struct PlaneExplainer::Parts {
  explicit Parts(const Segmentation& s)
      : scene(s),
        what_if(s),
        index(s.graph.patches),
        hypotheses(with_inliers(index, s.selection, s.options.planes)),
        pairs(pair_terms(hypotheses, index, s.graph, s.options.planes)),
        plane_of(hypotheses.size(), kNone) {
    for (std::size_t p = 0; p < s.planes.size(); ++p)
      if (s.planes[p].role == PlaneRole::Support)
        plane_of[s.planes[p].hypothesis] = static_cast<std::int32_t>(p);
  }

  /// The patches at these positions of the index.
  std::vector<std::uint32_t> ids(const Bits& positions) const {
    std::vector<std::uint32_t> patches;
    for_each(positions, [&](std::size_t i) { patches.push_back(index.patch(i)); });
    std::ranges::sort(patches);
    return patches;
  }

  HypothesisReport report(std::uint32_t m) const {
    const std::vector<PlaneHypothesis>& all = scene.selection.hypotheses;
    HypothesisReport r{m, all[m], plane_of[m], {}, ids(hypotheses[m].inliers)};
    for (const std::uint32_t k : scene.selection.selected) {
      const std::size_t at = m * all.size() + k;
      const PairCost pair{k, plane_of[k],
                          manhattan_deviation(all[m].plane.normal, all[k].plane.normal),
                          pairs.angle[at], pairs.overlap[at]};
      if (k != m && pair.cost() > kNothing) r.pairs.push_back(pair);
    }
    std::ranges::stable_sort(r.pairs, std::greater<>(), &PairCost::cost);
    return r;
  }

  /// A face and what it pays for each supporting plane; the overlap with other faces is left out.
  HypothesisReport face_report(const SupportingPlane& face, double& lambda) const {
    std::vector<SupportingPlane> supporting;
    std::vector<std::int32_t> ids;
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
      if (scene.planes[p].role != PlaneRole::Support) continue;
      supporting.push_back(scene.planes[p]);
      ids.push_back(static_cast<std::int32_t>(p));
    }
    const FaceTerms terms = face_terms(face.plane, scene.graph.patches, supporting,
                                       scene.patch_plane, scene.options.planes);
    lambda = terms.lambda;
    HypothesisReport r;
    r.hypothesis.plane = face.plane;
    r.hypothesis.selected = true;
    r.hypothesis.inlier_count = static_cast<std::uint32_t>(terms.inliers.size());
    for (const std::uint32_t p : terms.inliers)
      r.hypothesis.inlier_area += scene.graph.patches[p].area;
    r.hypothesis.data_cost = r.hypothesis.flip_cost = terms.data_cost;
    for (std::size_t k = 0; k < supporting.size(); ++k) {
      r.hypothesis.flip_cost += terms.angle_cost[k];
      const double angle = manhattan_deviation(face.plane.normal, supporting[k].plane.normal);
      if (terms.angle_cost[k] > kNothing)
        r.pairs.push_back({supporting[k].hypothesis, ids[k], angle, terms.angle_cost[k], 0});
    }
    std::ranges::stable_sort(r.pairs, std::greater<>(), &PairCost::cost);
    r.inliers = terms.inliers;
    return r;
  }

  /// Positions in the index of the patches within `radius` of a place, and that of one patch.
  Bits near(const Eigen::Vector3f& place, double radius) const {
    Bits found(index.words(), 0);
    for (std::size_t i = 0; i < index.size(); ++i)
      if ((index.centroid(i) - place).norm() <= static_cast<float>(radius)) insert(found, i);
    return found;
  }

  std::size_t position(std::uint32_t patch) const {
    std::size_t at = 0;
    while (index.patch(at) != patch) ++at;
    return at;
  }

  /// What grows from the patch at a position alone.
  void add_local_plane(MissingExplanation& x, std::size_t at) const {
    const Eigen::Vector3f c = index.centroid(at), n = index.normal(at);
    const Seed seed{{n, n.dot(c)}, c, static_cast<std::uint32_t>(at)};
    const PlaneSearch search(index, scene.options.planes);
    const std::vector<Hypothesis> fits = search.fit_each({seed}, {}, 0);
    if (fits.empty()) return;
    x.local.emplace();
    x.local->plane = fits[0].plane;
    x.local->inlier_count = fits[0].support;
    x.local->data_cost = data_cost(fits[0].support, scene.selection.lambda);
    x.local_inliers = ids(fits[0].inliers);
    for (const std::uint32_t p : x.local_inliers)
      x.local->inlier_area += scene.graph.patches[p].area;
  }

  const Segmentation& scene;
  WhatIf what_if;
  PatchIndex index;
  std::vector<Hypothesis> hypotheses;
  PairTerms pairs;
  std::vector<std::int32_t> plane_of;  // the supporting plane that each hypothesis became
};

PlaneExplainer::PlaneExplainer(const Segmentation& scene) {
  if (!scene.method.is_ours())
    throw Error(Error::Kind::Usage, "explain: the result is of method `" + scene.method.name +
                                        "`, which says nothing of its planes; segment with ours");
  for (const SupportingPlane& plane : scene.planes) {
    if (plane.role != PlaneRole::Support) continue;
    if (plane.hypothesis >= scene.selection.hypotheses.size() ||
        !scene.selection.hypotheses[plane.hypothesis].selected)
      throw Error(Error::Kind::Input, "explain: a plane grew from hypothesis " +
                                          std::to_string(plane.hypothesis) +
                                          ", which was not selected; segment the scene again");
  }
  parts_ = std::make_unique<Parts>(scene);
}
PlaneExplainer::~PlaneExplainer() = default;

PlaneExplanation PlaneExplainer::plane(std::uint32_t index, const std::vector<std::uint32_t>& truth,
                                       Flips with_flips) {
  const Segmentation& scene = parts_->scene;
  if (index >= scene.planes.size())
    throw Error(Error::Kind::Usage, "explain: there is no plane " + std::to_string(index) +
                                        "; the scene has " + std::to_string(scene.planes.size()));
  if (!truth.empty() && truth.size() != scene.point_plane.size())
    throw Error(Error::Kind::Input, "truth: has " + std::to_string(truth.size()) +
                                        " points, the scene has " +
                                        std::to_string(scene.point_plane.size()));
  PlaneExplanation x;
  x.index = index;
  x.plane = scene.planes[index];
  const bool is_face = x.plane.role == PlaneRole::Face;
  x.lambda = scene.selection.lambda;
  x.chosen = is_face ? parts_->face_report(x.plane, x.lambda) : parts_->report(x.plane.hypothesis);
  for (std::uint32_t m = 0; m < scene.selection.hypotheses.size(); ++m) {
    const PlaneHypothesis& h = scene.selection.hypotheses[m];
    if (!is_face && !h.selected && h.blocked_by == static_cast<std::int32_t>(x.plane.hypothesis))
      x.beaten.push_back(parts_->report(m));
  }
  std::map<std::uint32_t, std::uint64_t> shares;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (scene.point_plane[i] == static_cast<std::int32_t>(index)) ++shares[truth[i]];
  for (const auto& [label, points] : shares) x.truth.push_back({label, points});
  std::ranges::stable_sort(x.truth, std::greater<>(), &ObjectShare::points);
  if (with_flips == Flips::Skip) return x;
  std::vector<std::uint32_t> patches;
  for (std::uint32_t p = 0; p < scene.patch_plane.size(); ++p)
    if (scene.plane_of(p) == static_cast<std::int32_t>(index)) patches.push_back(p);
  constexpr float kSame = 0.985f;  // 10 degrees
  const auto is_gone = [&](const Trial& trial) {
    const std::int32_t next = successor(trial, patches, is_face);
    return next == kNone || std::abs(trial.planes[static_cast<std::size_t>(next)].plane.normal.dot(
                                x.plane.plane.normal)) < kSame;
  };
  x.flips = is_face
                ? parts_->what_if.seek_plane_flips(is_gone, {"planes.face_area", "planes.sigma"})
                : parts_->what_if.seek_plane_flips(is_gone);
  return x;
}

MissingExplanation PlaneExplainer::missing(const Eigen::Vector3f& place, double radius,
                                           Flips with_flips) {
  const Segmentation& scene = parts_->scene;
  MissingExplanation x;
  x.place = place;
  x.patch = report_patch(scene, patch_at(scene, place));
  x.distance = static_cast<double>((x.patch.patch.centroid - place).norm());
  x.lambda = scene.selection.lambda;
  if (!scene.patch_face.empty()) x.face = scene.patch_face[x.patch.id];
  const std::size_t at = parts_->position(x.patch.id);
  parts_->add_local_plane(x, at);
  if (!(radius > 0)) radius = 2 * static_cast<double>(scene.graph.patch_size);
  const Bits near = parts_->near(x.patch.patch.centroid, radius);
  for (const bool holding : {true, false}) {
    for (std::uint32_t m = 0; m < parts_->hypotheses.size(); ++m) {
      const Bits& inliers = parts_->hypotheses[m].inliers;
      if (contains(inliers, at) != holding || !any_common(inliers, near)) continue;
      x.near.push_back(parts_->report(m));
      x.holds.push_back(holding);
    }
  }
  if (with_flips == Flips::Skip || x.patch.plane != kNone) return x;
  x.flips = parts_->what_if.seek_plane_flips(
      [&](const Trial& trial) { return trial.patch_plane[x.patch.id].plane != kNone; });
  return x;
}

}  // namespace planescope
