// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/planes.hpp"
#include "planescope/synthesize.hpp"

/// \file Scores of a segmentation against ground truth: eqs. (11) and (12) of the paper and the
/// measures of its field.
namespace planescope {

/// A ground-truth region and the segment that overlaps it best.
struct RegionScore {
  std::uint32_t truth = 0;      ///< its label
  std::uint64_t points = 0;     ///< |R|
  std::uint32_t predicted = 0;  ///< best segment (of equals: the lowest label), or kNoSegment
  double overlap = 0;           ///< |R n S| / |R u S|
};

/// Scores over the points with a truth label other than 0; a segment S is the set of those that it
/// holds. Segment 0 never matches; its points still count as missed.
struct LabelScores {
  double weighted_overlap = 0;  ///< WO, eq. (12): sum |R| max_S |R n S|/|R u S| / sum |R|
  double overlap = 0;           ///< UO, eq. (11): the plain mean of max_S |R n S|/|R u S|
  double over_segmentation =
      0;  ///< F_os: 1 - mean share of a region that its best segment (by intersection) covers
  double under_segmentation = 0;  ///< F_us: share of points in segments that lie outside the
                                  ///< segment's main region; 0 if no point is in a segment
  double adjusted_rand = 0;       ///< ARI (Hubert and Arabie 1985); unlabelled predictions are
                             ///< singletons; 1 where truth and prediction are both trivial alike
  double variation_of_information =
      0;  ///< [bit] H(R|S) + H(S|R) (Meila 2007); unlabelled predictions are one class
  std::uint32_t regions = 0;            ///< truth regions
  std::uint32_t segments = 0;           ///< segments that hold a counted point
  std::vector<RegionScore> per_region;  ///< by truth label, ascending
};

/// \param predicted segment labels; \param truth region labels, same length. 0: see LabelScores.
/// \throws Error{Kind::Input} different lengths, or no point with truth.
LabelScores score_labels(std::span<const std::uint32_t> predicted,
                         std::span<const std::uint32_t> truth);

/// Merges the parts of an object in a truth that numbers them: 0 stays 0, else label / divide + 1.
/// The table-top data set has 1-9 for parts of the table, 20-29 for those of object 1, ...: divide
/// 10. \throws Error{Kind::Usage} divide is 0; Error{Kind::Input} a label + 1 does not fit.
std::vector<std::uint32_t> merge_truth(std::span<const std::uint32_t> labels, std::uint32_t divide);

/// What is counted, and what a region is. The default: every point whose true label is not 0.
struct TruthPolicy {
  enum class Unlabelled {
    Missed,   ///< points in no segment never match, and still count in their region's size
    Ignored,  ///< they do not count at all
  };
  std::uint32_t divide = 1;                ///< regions are label / divide: merge_truth()
  std::uint32_t from = 0;                  ///< only labels from here up count
  std::vector<std::uint32_t> ignore = {};  ///< labels that do not count, besides 0
  Unlabelled unlabelled = Unlabelled::Missed;
};

/// The truth to score against: 0 where a point does not count. Labels of `policy` are those of the
/// file, before they are divided.
/// \throws as merge_truth(); Error{Kind::Input} different lengths.
std::vector<std::uint32_t> apply_policy(std::span<const std::uint32_t> predicted,
                                        std::span<const std::uint32_t> truth,
                                        const TruthPolicy& policy);

/// Eqs. (11) and (12) over some of the regions. The segments are the same as for all of them: a
/// segment that leaks into another region overlaps less.
struct ObjectScores {
  double weighted_overlap = 0, overlap = 0;
  std::uint32_t regions = 0;  ///< if none: no scores
};

/// \param first lowest true label of an object, as in the file, whatever `divide` did to it.
ObjectScores score_objects(const LabelScores& scores, std::uint32_t first,
                           std::uint32_t divide = 1);

/// How well region borders are drawn in an organised view. A border pixel has a 4-neighbour of
/// another label, both of them with truth.
struct BoundaryScores {
  double recall = 0;     ///< share of the truth's border pixels with a predicted one near
  double precision = 0;  ///< share of the predicted border pixels with a true one near
};

/// \param width columns, rows follow from it; \param tolerance [pixel] near: at most this far along
/// x and along y. A share of nothing is 1.
/// \throws Error{Kind::Input} different lengths, or not a multiple of the width.
BoundaryScores score_boundaries(std::span<const std::uint32_t> predicted,
                                std::span<const std::uint32_t> truth, std::uint32_t width,
                                std::uint32_t tolerance = 2);

/// When a found plane matches a true face.
struct PlaneTolerance {
  double angle = 5.0;     ///< [deg] between the normals, either way round
  double offset = 0.05;   ///< [m] distance of the face's centroid from the found plane
  double min_area = 0.5;  ///< [m^2] smaller true planes need not be found (and may be)
};

/// Found planes against true ones. Faces that the tolerance cannot tell apart (table tops of one
/// height, top and underside of a board) are one true plane: from the largest face down, each joins
/// the first true plane whose largest face has it within the tolerance, or starts one; areas add
/// up. True and found planes are matched one to one, nearest first.
struct PlaneScores {
  double recall = 0;              ///< share of true planes of at least min_area that are matched
  double structural_recall = 0;   ///< the same, of those with a structural face
  double precision = 0;           ///< share of found planes that lie on a true face of any area
  std::uint32_t true_planes = 0;  ///< true planes of at least min_area
  std::uint32_t structural_planes = 0;  ///< of these, with a structural face
  std::uint32_t found_planes = 0;
  std::uint32_t invented = 0;  ///< found planes that lie on no true face
  std::uint32_t repeated = 0;  ///< found planes that lie on true faces which others match already
  double mean_angle = 0;       ///< [deg] of matched pairs
  double mean_offset = 0;      ///< [m] of matched pairs
  double max_angle = 0;        ///< [deg] of matched pairs
  double max_offset = 0;       ///< [m] of matched pairs
  double manhattan_deviation =
      0;  ///< [deg] mean over pairs of found planes from parallel or orthogonal
  std::vector<std::int32_t> match;  ///< per true face: the found plane that its true plane is
                                    ///< matched with, or kNone
};

/// Angle and offset of a pair are those of the true plane's face that is nearest to the found one.
/// Offsets are measured at the faces, because that is where a tilt matters. A share of nothing
/// is 1. \param found,truth relative to the same origin.
PlaneScores score_planes(std::span<const Plane> found, std::span<const TruePlane> truth,
                         const PlaneTolerance& tolerance = {});

/// Labels of another cloud of the same place, by the nearest point.
struct NearestLabels {
  std::vector<std::uint32_t> labels;  ///< per point; 0 where none is within the distance
  double mean_distance = 0;           ///< [m] of the points that have one
  std::size_t beyond = 0;             ///< finite points that have none
};

/// Gives each point the label of the nearest point of `truth` (of equally near ones the first): for
/// maps that were fused from frames, whose points are not those of the truth.
/// \param max_distance [m] further points do not count. \throws Error{Kind::Input} the truth has no
/// labels; Error{Kind::Usage} the distance is not positive.
NearestLabels nearest_labels(const PointCloud& truth, const PointCloud& cloud, double max_distance);

}  // namespace planescope
