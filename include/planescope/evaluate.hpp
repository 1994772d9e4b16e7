// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planescope/planes.hpp"
#include "planescope/synthesize.hpp"

/// \file Scores of a segmentation against ground truth: eqs. (11) and (12) of the paper and the
/// measures of its field.
namespace planescope {

/// A ground-truth region and the segment that overlaps it best.
struct RegionScore {
  std::uint32_t truth = 0;      ///< its label
  std::uint64_t points = 0;     ///< |R|
  std::uint32_t predicted = 0;  ///< best segment, or kNoSegment
  double overlap = 0;           ///< |R n S| / |R u S|
};

/// Scores over all points with a truth label other than 0. Segment 0 never matches; its points
/// still count as missed.
struct LabelScores {
  double weighted_overlap = 0;  ///< WO, eq. (12): overlaps weighted by region size
  double overlap = 0;           ///< UO, eq. (11): their plain mean
  double over_segmentation =
      0;  ///< F_os: 1 - mean share of a region that its best segment (by intersection) covers
  double under_segmentation =
      0;  ///< F_us: share of points in segments that lie outside the segment's main region
  double adjusted_rand = 0;             ///< ARI; unlabelled predictions are singletons
  double variation_of_information = 0;  ///< [bit]; unlabelled predictions are one class
  std::uint32_t regions = 0;            ///< truth regions
  std::uint32_t segments = 0;           ///< segments that hold a counted point
  std::vector<RegionScore> per_region;  ///< by truth label, ascending
};

/// \param predicted segment labels; \param truth region labels, same length. 0: see LabelScores.
/// \throws Error{Kind::Input} different lengths, or no point with truth.
LabelScores score_labels(std::span<const std::uint32_t> predicted,
                         std::span<const std::uint32_t> truth);

/// Tolerances for a found plane to match a true one.
struct PlaneTolerance {
  double angle = 5.0;    ///< [deg]
  double offset = 0.05;  ///< [m] difference of the two planes, distances measured at `centre`
};

/// Found planes against true ones, matched one to one, nearest first.
struct PlaneScores {
  double recall = 0, precision = 0;
  double mean_angle = 0;   ///< [deg] of matched pairs
  double mean_offset = 0;  ///< [m] of matched pairs
  double manhattan_deviation =
      0;  ///< [deg] mean over pairs of found planes from parallel or orthogonal
  std::vector<std::int32_t> match;  ///< per true plane: index of the found one, or kNone
};

/// \param centre where offsets are compared [m], relative to the cloud's origin.
PlaneScores score_planes(std::span<const Plane> found, std::span<const TruePlane> truth,
                         const Eigen::Vector3f& centre, const PlaneTolerance& tolerance = {});

}  // namespace planescope
