// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "planes/patch_index.hpp"
#include "planes/seeds.hpp"
#include "planescope/options.hpp"

/// \file Rough planes become fitted planes.
namespace planescope {

/// A refitted plane and the patches that support it.
struct Hypothesis {
  Plane plane;
  std::uint32_t support = 0;  ///< |I|, the size of `inliers`
  Bits inliers;               ///< positions in the index that it was fitted on
  bool held = false;          ///< it, or a near-duplicate, was selected in an earlier run
};

/// Fits planes to the inliers among the patches of one index; the index must outlive it.
class PlaneSearch {
 public:
  PlaneSearch(const PatchIndex& index, const PlaneOptions& options);

  /// The least-squares plane of the inliers of `plane`, refitted until they settle or `steps`
  /// times, with its own inliers.
  ///
  /// Differs from the paper: only inliers whose normals agree to 20 degrees enter the fit, and a
  /// plane whose inliers are mostly others has no support: the gate of 0.8 (37 degrees) lets pass
  /// what is no surface but slices through several, and such planes have more inliers than a table.
  Hypothesis refit(const Plane& plane, int steps) const;

  /// Fits the seeds in their order, but for those that are close inliers (within sigma / 2 and 10
  /// degrees) of a plane or a local fit made earlier: they would end there. At most `most` fits;
  /// returns those with at least `least_support` inliers. Equal at any number of threads.
  std::vector<Hypothesis> fit_uncovered(std::vector<Seed> seeds, std::size_t most,
                                        double least_support) const;

  /// Leaves out the seeds that are close inliers of one of `known`.
  void drop_covered(std::vector<Seed>& seeds, const std::vector<Hypothesis>& known) const;

  /// Fits all seeds but those whose plane is close (sigma / 2 at the seed's centre and 10 degrees)
  /// to one of `known`; returns those with at least `least_support` inliers.
  std::vector<Hypothesis> fit_each(const std::vector<Seed>& seeds,
                                   const std::vector<Hypothesis>& known,
                                   double least_support) const;

 private:
  struct Fit {
    Hypothesis hypothesis;
    Bits covered;  ///< close inliers: of the plane, and, near the seed, of the first local fit
  };
  /// From a seed's plane to that of its inliers within 10 sigma, then 40 sigma, then everywhere: a
  /// patch normal that is a few degrees off leaves the slab of sigma within about ten sigma.
  Fit fit(const Seed& seed) const;
  bool close(const Plane& plane, const Seed& seed) const;
  std::vector<Seed> next_batch(std::vector<Seed>& pending, const Bits& covered,
                               std::size_t most) const;

  const PatchIndex& index_;
  float sigma_;
  float gate_;
  float fit_gate_;
};

}  // namespace planescope
