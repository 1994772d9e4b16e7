// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "planescope/cloud.hpp"

/// \file Every option of the engine: plain values with defaults, meaning and unit. Names in files
/// and on the command line are `<group>.<member>`, such as `planes.sigma`; option_table() lists
/// them.
namespace planescope {

/// Called by long stages: a stage's name and the fraction of it that is done, in [0, 1]. From one
/// thread only.
using Progress = std::function<void(std::string_view stage, double fraction)>;

/// Section III-A of the paper: VCCS supervoxels (Papon et al., CVPR 2013).
struct PatchOptions {
  double voxel_size = 0.02;  ///< R_voxel [m]: edge of a voxel; not below the cloud's median spacing
  double patch_size = 0.10;  ///< R_seed [m]: distance of the seeds; more than voxel_size
  /// [1] voxels and patches grow with the distance from the sensor to this power, and are
  /// voxel_size and patch_size at the median distance; 0: the same everywhere. For single scans,
  /// whose samples lie the further apart the further away they are. The sensor is where the cloud
  /// says, else at (0, 0, 0) of its own coordinates.
  double range_exponent = 0.0;
  /// [m] edge of the smallest cells in which points are projected onto their surroundings' plane
  /// before anything else, about the noise; 0: they are taken as they are. For maps put together
  /// without fusion, whose points scatter across the surface more widely than they lie apart along
  /// it. Only patches are made of the projected points; results keep the points as they were.
  double smoothing = 0.0;
  double weight_color = 0.0;    ///< [1] growth: weight of the colour distance
  double weight_spatial = 1.0;  ///< [1] growth: weight of the distance in units of patch_size
  double weight_normal = 4.0;   ///< [1] growth: weight of 1 - |n . n'|
};

/// Which pairs of planes pay for not being parallel or orthogonal (eq. (6)).
enum class AngleScope {
  All,       ///< every pair, as in the paper
  Touching,  ///< only pairs that have adjacent patches among their inliers
};

/// How the planes are selected.
enum class PlaneSolver {
  LsaTr,       ///< LSA-TR (Gorelick et al., CVPR 2014), as in the paper
  LsaTrTabu,   ///< LSA-TR, then 1-flip tabu search; the better of the two
  Exhaustive,  ///< all subsets; at most 24 hypotheses: the oracle of the tests
};

/// How labels are assigned to patches once planes are selected (eq. (10)).
enum class AssignmentSolver { Expansion, Icm };

/// Section IV of the paper.
struct PlaneOptions {
  double sigma = 0.05;    ///< [m] inlier distance r(c_i, p) < sigma
  double min_area = 0.5;  ///< [m^2] lambda of eq. (4) as an area: lambda = min_area / area-weighted
                          ///< median patch area
  /// [m^2] smallest planar face of an object (see SupportingPlane::role); 0: none are looked for
  double face_area = 0.1;
  double alpha = 10.0;  ///< [deg] tolerance of the angle to parallel or orthogonal in eq. (6)
  double normal_gate =
      0.8;  ///< [1] inliers need |n_i . n_p| of at least this; 0 switches the gate off
  double max_curvature = 0.05;  ///< [1] only flatter patches propose a plane
  double weight_angle = 1.0;    ///< [1] weight of the angle term of eq. (6)
  double weight_overlap = 1.0;  ///< [1] weight of the overlap term of eq. (6)
  AngleScope angle_scope = AngleScope::All;
  PlaneSolver solver = PlaneSolver::LsaTrTabu;
  AssignmentSolver assignment = AssignmentSolver::Expansion;
  double smoothness =
      0.5;  ///< [1] w of eq. (10): the Potts weight of an edge whose patches differ in label
  std::uint32_t triples = 200;  ///< random triples of patch centroids that propose a plane too
  std::uint32_t max_hypotheses = 400;  ///< hypotheses kept for selection, largest support first
  std::uint32_t tabu_steps = 3000;     ///< 1-flip moves of the tabu search
  std::uint64_t random_seed = 1;       ///< seed of the triples
};

/// Section III-B of the paper, eq. (1), and LCCP (Stein et al., CVPR 2014) for edges between
/// patches on no plane.
struct EdgeOptions {
  double concavity_tolerance =
      10.0;  ///< [deg] a concave edge with a smaller angle between normals is ON
  /// [1] allowed step, in voxel sizes, beyond what the normals explain. Differs from LCCP, which
  /// has 0.1: centroids of patches that hold both sides of a board lie further apart than that.
  double smoothness_tolerance = 1.0;
  /// [deg] upper end of LCCP's sanity criterion; 0 switches it off. Differs from LCCP, which has
  /// 60: at the sharp folds of boxes that refuses half of the edges.
  double singular_angle = 40.0;
  /// [deg] patches whose normals lie further apart are the two sides of a board or rim: ON if back
  /// to back, OFF if they face each other across a gap. LCCP has no such rule, and decides by the
  /// intersection of two nearly parallel planes, which is noise. 180 switches it off.
  double rim_angle = 120.0;
  /// A convex edge needs a common neighbour that is convex to both. Differs from LCCP, which needs
  /// it against leaks to the supporting surface: here the planes have cut those, and objects a few
  /// patches wide lack such neighbours.
  bool extended_convexity = false;
};

/// Connected components of ON edges.
struct SegmentOptions {
  std::uint32_t min_patches =
      3;  ///< smaller segments join the neighbour with the longest shared border
};

/// All options of segment(). Values are plain; validate() says what is wrong with them.
struct Options {
  PatchOptions patches;
  PlaneOptions planes;
  EdgeOptions edges;
  SegmentOptions segments;

  /// Room scale: R_voxel 2 cm, R_seed 10 cm, sigma 5 cm.
  static Options room();
  /// Table-top scale, as a Kinect sees it from about a metre: R_voxel 0.75 cm, R_seed 3 cm, sigma 1
  /// cm.
  static Options tabletop();
  /// Radii, sigma and minimum area from the cloud's own spacing, extent and noise; why: see
  /// describe_scale(). \throws Error{Kind::Input} no finite point.
  /// \throws Error{Kind::Computation} it is far too large for metres.
  static Options automatic(const PointCloud& cloud);

  /// \throws Error{Kind::Usage} an option is out of range or contradicts another: its name, value,
  /// range, what to do.
  void validate() const;
};

/// What a cloud's points say about their own scale; what Options::automatic() goes by.
struct CloudScale {
  std::size_t finite_points = 0;
  /// [m] median of 1 / sqrt(local density): the side of the square of surface that a point stands
  /// for.
  double spacing = 0;
  /// [m] median over places of the rms distance to a plane through about 24 points; of organised
  /// views at least that of a structured-light camera at the median depth, 1.4 mm z^2 (Khoshelham
  /// and Elberink, Sensors 2012), because steps of depth look flat from near by.
  double noise = 0;
  /// [m] smallest voxel, from 1.05 spacings (views: 1.5) and surfels' radius up, at which occupied
  /// voxels have 5 neighbours on average (8 are a filled plane) and surfaces of maps hang together:
  /// scan lines and the rows of a fused map's points lie further apart than their density says.
  double connected_voxel = 0;
  /// [m] median distance from the sensor, where the cloud was seen from one place: an organised
  /// view, or a list of points whose density falls with the distance from the sensor (else the
  /// origin of the coordinates) and which show no surface behind another. 0: a map of many places.
  double median_range = 0;
  double far_range = 0;                              ///< [m] 90th percentile of that distance
  Eigen::Vector3f extent = Eigen::Vector3f::Zero();  ///< [m] between the 1st and 99th percentile
};

/// Measures the scale on a fixed sample of the cloud's points.
/// \throws Error{Kind::Input} no finite point.
CloudScale measure_scale(const PointCloud& cloud);

/// What is likely wrong where the options do not fit the cloud: voxels smaller than the spacing,
/// millimetres taken for metres. Empty where nothing is.
std::string scale_warning(const CloudScale& scale, const Options& options);

/// One line of option_table().
struct OptionInfo {
  std::string name;     ///< `planes.sigma`
  std::string unit;     ///< `m`, `deg`, `m^2`, `1`, `choice`, `flag`, `count`
  std::string range;    ///< what validate() takes, in words: `0.0001 to 10`
  std::string meaning;  ///< one line, with which way to turn it
};

/// Every option by name, in the order of the structs.
std::vector<OptionInfo> option_table();

/// Sets one option by name from text. \throws Error{Kind::Usage} unknown name (the nearest one is
/// named) or bad value.
void set_option(Options& options, std::string_view name, std::string_view value);

/// The value of one option as text that set_option() takes back unchanged. \throws
/// Error{Kind::Usage} unknown name.
std::string get_option(const Options& options, std::string_view name);

}  // namespace planescope
