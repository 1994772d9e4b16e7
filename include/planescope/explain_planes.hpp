// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "planescope/explain.hpp"
#include "planescope/pipeline.hpp"

/// \file Why a plane was chosen, and why there is none at a place: the terms of the energy, eqs.
/// (3) to (6), by hypothesis and by pair.
namespace planescope {

/// V of eq. (6) between a hypothesis and a selected one.
struct PairCost {
  std::uint32_t hypothesis = 0;  ///< the other one
  std::int32_t plane = kNone;    ///< the supporting plane it became, or kNone
  double angle = 0;              ///< [deg] deviation from parallel or orthogonal
  double angle_cost = 0;         ///< weighted
  double overlap_cost = 0;       ///< weighted
  double cost() const { return angle_cost + overlap_cost; }
};

/// A hypothesis with what it gains (D) and what it pays (V).
struct HypothesisReport {
  std::uint32_t index = 0;  ///< into PlaneSelection::hypotheses
  PlaneHypothesis hypothesis;
  std::int32_t plane = kNone;   ///< the supporting plane it became
  std::vector<PairCost> pairs;  ///< with every selected hypothesis where V is more than 1e-6,
                                ///< dearest first
  std::vector<std::uint32_t> inliers;  ///< patches, ascending
};

/// How many points of a plane lie on a true object.
struct ObjectShare {
  std::uint32_t truth = 0;  ///< label; 0: points without truth
  std::uint64_t points = 0;
};

/// Why a supporting plane or a face (SupportingPlane::role) is there.
struct PlaneExplanation {
  std::uint32_t index = 0;  ///< into Segmentation::planes
  SupportingPlane plane;
  double lambda = 0;  ///< [patches] of eq. (4); of a face: from planes.face_area
  /// Of a face, which is no hypothesis of the selection: `index` means nothing, the pairs are what
  /// it pays for the directions of the supporting planes, and the inliers those on none of these.
  HypothesisReport chosen;
  std::vector<HypothesisReport> beaten;  ///< hypotheses whose dearest pair is with this one
  std::vector<Flip> flips;               ///< after which there is no such plane (`rule` is unused)
  std::vector<ObjectShare> truth;        ///< what lies on it, most first; empty without truth
};

/// Why there is no plane at a place.
struct MissingExplanation {
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  PatchReport patch;          ///< the nearest one
  double distance = 0;        ///< [m] of its centroid from the place
  std::int32_t face = kNone;  ///< the face that it lies on, if it does (SupportingPlane::role)
  double lambda = 0;
  /// The plane that grows from this patch alone, refitted to its inliers: with its inliers, area
  /// and D. Nothing where no patch agrees with it.
  std::optional<PlaneHypothesis> local;
  std::vector<std::uint32_t> local_inliers;  ///< patches of `local`, ascending
  std::vector<HypothesisReport> near;  ///< hypotheses with inliers near the place: those that hold
                                       ///< the patch first, then by inliers
  std::vector<bool> holds;             ///< per hypothesis in `near`: the patch is an inlier
  std::vector<Flip> flips;             ///< after which the patch lies on a plane (`rule` is unused)
};

/// Explains planes of one scene; keeps what it computed.
class PlaneExplainer {
 public:
  /// The scene must outlive it. \throws Error{Kind::Usage} the method is a peer;
  /// Error{Kind::Input} its planes and hypotheses do not belong together.
  explicit PlaneExplainer(const Segmentation& scene);
  ~PlaneExplainer();
  PlaneExplainer(const PlaneExplainer&) = delete;
  PlaneExplainer& operator=(const PlaneExplainer&) = delete;

  /// \param truth labels of the points, or empty.
  /// \throws Error{Kind::Usage} there is no such plane; Error{Kind::Input} truth of other length.
  PlaneExplanation plane(std::uint32_t index, const std::vector<std::uint32_t>& truth = {},
                         Flips with_flips = Flips::Seek);

  /// \param place [m] relative to the cloud's origin. \param radius [m] what is near; 0: two patch
  /// sizes. \throws Error{Kind::Usage} the scene has no patch.
  MissingExplanation missing(const Eigen::Vector3f& place, double radius = 0,
                             Flips with_flips = Flips::Seek);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// In words.
std::string describe(const PlaneExplanation& explanation);
std::string describe(const MissingExplanation& explanation);

}  // namespace planescope
