// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "planes/patch_index.hpp"
#include "planescope/options.hpp"
#include "planescope/planes.hpp"

/// \file What proposes planes (Section IV-A): single flat patches and triples of patches.
namespace planescope {

/// A rough plane, good near its centre.
struct Seed {
  Plane plane;
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  std::uint32_t position = 0;  ///< in the index, of the patch (the first of the triple)
};

/// One seed for each patch with curvature at most `max_curvature`, the flattest and largest first:
/// their planes are the most likely to hold, and what they cover need not be tried again.
std::vector<Seed> patch_seeds(const PatchIndex& index, double max_curvature);

/// Planes through the centroids of `count` random triples of patches.
///
/// Differs from the paper: three patches from anywhere rarely share a surface, so the second and
/// third are drawn within `radius` of the first, and a triple counts only if its plane passes the
/// normal gate of all three. A few draws that fail are repeated; one that never succeeds is left
/// out, so that fewer than `count` may come back.
std::vector<Seed> triple_seeds(const PatchIndex& index, const PlaneOptions& options, float radius);

}  // namespace planescope
