// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "planescope/options.hpp"
#include "planescope/patches.hpp"

/// \file Section IV of the paper: plane hypotheses, the global energy that selects among them, and
/// the graph cut that assigns patches to the selected ones.
namespace planescope {

/// The plane normal . x = distance, with unit normal.
struct Plane {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit
  float distance = 0;  ///< [m] along normal, relative to the cloud's origin

  /// Signed distance of a point [m]; positive on the side of the normal.
  float signed_distance(const Eigen::Vector3f& point) const { return normal.dot(point) - distance; }
};

/// A plane that was proposed (IV-A), with its terms of the energy.
struct PlaneHypothesis {
  Plane plane;  ///< refitted by least squares to its inliers; its normal agrees with most of theirs
  std::uint32_t inlier_count =
      0;                  ///< |I|: patches with r(c_i, p) < sigma and |n_i . n_p| >= normal_gate
  float inlier_area = 0;  ///< [m^2] of those patches
  double data_cost = 0;   ///< D of eq. (4)
  bool selected = false;  ///< x_m of the minimum
  double flip_cost =
      0;  ///< E(with it) - E(without it), the others held as selected; negative: it pays
  std::int32_t blocked_by =
      kNone;  ///< for a rejected one: the selected hypothesis whose V cost it most
  double blocked_angle_cost = 0;    ///< angle term of that pair, weighted (eq. (6))
  double blocked_overlap_cost = 0;  ///< overlap term of that pair, weighted (eq. (6))
};

/// The outcome of selection: all hypotheses that entered it, and which of them won.
struct PlaneSelection {
  std::vector<PlaneHypothesis>
      hypotheses;  ///< by inlier count, descending; each with more than lambda inliers
  std::vector<std::uint32_t> selected;  ///< indices of the supporting planes, ascending
  double energy = 0;                    ///< E(X) of the selection; 0 if nothing is selected
  double lambda = 0;                    ///< lambda [patches] that was used
  std::uint32_t proposed = 0;           ///< number of proposals before merging and pruning
};

/// D of eq. (4) with the paper's gap closed: 1 - n/lambda below lambda, exp((lambda - n)/lambda) -
/// 1 above.
double data_cost(double inliers, double lambda);

/// Deviation from parallel or orthogonal, min(A, 90 - A) [deg], of two plane normals.
double manhattan_deviation(const Eigen::Vector3f& a, const Eigen::Vector3f& b);

/// The energy E(X) = sum D_m x_m + sum over pairs V_mn x_m x_n of eqs. (3) to (6), as numbers.
struct SelectionEnergy {
  std::vector<double> unary;  ///< D_m, n values
  std::vector<double>
      pairwise;  ///< V_mn, n x n, symmetric, zero diagonal, row-major; all at least 0

  std::size_t size() const { return unary.size(); }
  double operator()(const std::vector<bool>& x) const;  ///< E(x)
};

/// Minimises the energy. LsaTr: submodular-supermodular trust region, whose sub-problem here is
/// thresholding. LsaTrTabu: the better of that and of 1-flip tabu search from a greedy start. Ties
/// are broken towards the lower index. \throws Error{Kind::Usage} Exhaustive with more than 24
/// hypotheses.
std::vector<bool> minimise_selection(const SelectionEnergy& energy, PlaneSolver solver,
                                     std::uint32_t tabu_steps);

/// Proposes hypotheses (IV-A): one a flat patch and a seeded sample of triples of patches, each
/// refitted by least squares to its inliers; near-duplicates are merged, and those that D alone
/// already refuses (no more than lambda inliers) are dropped: V is never negative, so they cannot
/// be part of the minimum. Then selects the supporting planes among them by the energy of eqs. (3)
/// to (6) (IV-B). Reports progress as `hypotheses`, then `selection`.
PlaneSelection select_planes(const PatchGraph& graph, const PlaneOptions& options,
                             const Progress& progress = {});

/// Assigns each patch to a supporting plane or to none (IV-C, eq. (10)): U = r / sigma where the
/// normal gate is passed, 2 for "no plane", Potts over the adjacency; alpha-expansion, or ICM.
/// \returns per patch: index into `planes`, or kNone.
std::vector<std::int32_t> assign_planes(const PatchGraph& graph, const std::vector<Plane>& planes,
                                        const PlaneOptions& options, const Progress& progress = {});

}  // namespace planescope
