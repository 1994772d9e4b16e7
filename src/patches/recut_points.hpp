// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "planescope/patches.hpp"

/// \file Voxels hold points of both sides of a border. Here points choose between adjacent patches
/// by the surfaces themselves.
namespace planescope {

/// A patch as points near its border see it: a disc of its area, on its plane.
struct PatchDisc {
  Eigen::Vector3f normal, center;
  float radius = 0;  ///< [m]
  float weight = 1;  ///< [1] of the distance above the plane
  float noise = 0;   ///< [m] how much nearer to another patch a point of this one has to lie

  /// \param patch its normal and centroid give the plane.
  static PatchDisc of(const Patch& patch) {
    return {patch.normal, patch.centroid, std::sqrt(patch.area / std::numbers::pi_v<float>)};
  }

  /// [m] weighted distance above the plane, and `along` times that beyond the rim; where that is
  /// not less than `limit`, some number that is not.
  float distance(const Eigen::Vector3f& p, float along,
                 float limit = std::numeric_limits<float>::infinity()) const {
    const Eigen::Vector3f d = p - center;
    const float above = normal.dot(d);
    const float weighted = weight * std::abs(above);
    if (weighted >= limit) return weighted;
    const float beside = d.squaredNorm() - above * above;  // squared
    return beside > radius * radius ? weighted + along * (std::sqrt(beside) - radius) : weighted;
  }
};

/// What distances weigh.
struct RecutWeights {
  float along = 0;  ///< beyond a patch's rim, against above its plane
  float stay = 1;   ///< to the patch that has the point, against its rivals: near ties stay
};

/// Which patch each point ends in.
struct PointPatches {
  std::vector<std::int32_t> patch;   ///< per point of the cloud: its patch, or kNone
  std::vector<std::uint32_t> count;  ///< per patch: its points
};

/// As the graph has them.
PointPatches point_patches(const PatchGraph& graph);

/// Points of patches that have rivals go to the nearest of all these. No group of patches loses its
/// last points: it gets back what it had.
/// \param[in,out] points the counts are right before and after; kNone stays.
/// \param discs per patch. \param rivals per patch: those that may take its points.
/// \param group per patch: patches of one group stand for each other; below the number of patches.
void recut_points(const PointCloud& cloud, PointPatches& points,
                  const std::vector<PatchDisc>& discs, const NeighbourTable& rivals,
                  const RecutWeights& weights, std::span<const std::uint32_t> group);

}  // namespace planescope
