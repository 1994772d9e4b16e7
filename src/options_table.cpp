// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options_table.hpp"

#include <array>

namespace planescope {
namespace {

constexpr std::array<std::string_view, 2> kScopes = {"all", "touching"};
constexpr std::array<std::string_view, 3> kSolvers = {"lsa_tr", "lsa_tr+tabu", "exhaustive"};
constexpr std::array<std::string_view, 2> kAssignments = {"expansion", "icm"};

template <auto Group, auto Member>
auto& member(Options& options) {
  return (options.*Group).*Member;
}

template <auto Group, auto Member>
constexpr OptionChoice choice(std::span<const std::string_view> names) {
  using Value = std::remove_reference_t<decltype(member<Group, Member>(std::declval<Options&>()))>;
  return {names, [](Options& o) { return static_cast<int>(member<Group, Member>(o)); },
          [](Options& o, int index) { member<Group, Member>(o) = static_cast<Value>(index); }};
}

constexpr auto kPatches = &Options::patches;
constexpr auto kPlanes = &Options::planes;
constexpr auto kEdges = &Options::edges;
constexpr auto kSegments = &Options::segments;

constexpr OptionEntry kTable[] = {
    {"patches.voxel_size", "m", 1e-4, 10,
     "R_voxel, the edge of a voxel: smaller keeps finer detail, larger is faster",
     member<kPatches, &PatchOptions::voxel_size>},
    {"patches.patch_size", "m", 2e-4, 100,
     "R_seed, the distance of the seeds, more than voxel_size: smaller patches follow borders",
     member<kPatches, &PatchOptions::patch_size>},
    {"patches.range_exponent", "1", 0, 0.9,
     "voxels grow with distance from the sensor to this power: 0 in maps, up to 0.7 in single "
     "scans",
     member<kPatches, &PatchOptions::range_exponent>},
    {"patches.smoothing", "m", 0, 1,
     "cells in which scattered points are flattened first, about the noise: larger flattens more",
     member<kPatches, &PatchOptions::smoothing>},
    {"patches.weight_color", "1", 0, 1000,
     "weight of colour in growing patches: larger keeps them within one colour",
     member<kPatches, &PatchOptions::weight_color>},
    {"patches.weight_spatial", "1", 0, 1000,
     "weight of distance in growing patches: larger makes them rounder",
     member<kPatches, &PatchOptions::weight_spatial>},
    {"patches.weight_normal", "1", 0, 1000,
     "weight of normals in growing patches: larger keeps them flatter",
     member<kPatches, &PatchOptions::weight_normal>},
    {"planes.sigma", "m", 1e-5, 10,
     "largest distance of an inlier to its plane: larger bridges noise, smaller separates levels",
     member<kPlanes, &PlaneOptions::sigma>},
    {"planes.min_area", "m^2", 1e-6, 1e6,
     "smallest supporting plane (lambda of eq. (4) as an area): smaller finds more planes",
     member<kPlanes, &PlaneOptions::min_area>},
    {"planes.face_area", "m^2", 0, 1e6,
     "smallest planar face of an object that is reported: smaller finds more faces, 0 none",
     member<kPlanes, &PlaneOptions::face_area>},
    {"planes.alpha", "deg", 0.01, 45,
     "tolerance of the angle to parallel or orthogonal in eq. (6): larger forgives slanted planes",
     member<kPlanes, &PlaneOptions::alpha>},
    {"planes.normal_gate", "1", 0, 0.9999,
     "an inlier needs |n_i . n_p| of at least this: larger is stricter, 0 switches it off",
     member<kPlanes, &PlaneOptions::normal_gate>},
    {"planes.max_curvature", "1", 0, 1,
     "only patches flatter than this propose a plane: larger gives more hypotheses",
     member<kPlanes, &PlaneOptions::max_curvature>},
    {"planes.weight_angle", "1", 0, 1000,
     "weight of the angle term of eq. (6): larger insists on a Manhattan world, 0 ignores angles",
     member<kPlanes, &PlaneOptions::weight_angle>},
    {"planes.weight_overlap", "1", 0, 1000,
     "weight of the overlap term of eq. (6): larger refuses planes that share inliers",
     member<kPlanes, &PlaneOptions::weight_overlap>},
    {"planes.angle_scope", "choice", 0, 0,
     "which pairs of planes pay for their angle: all as in the paper, or only touching ones",
     choice<kPlanes, &PlaneOptions::angle_scope>(kScopes)},
    {"planes.solver", "choice", 0, 0,
     "how planes are selected: lsa_tr as in the paper, then tabu search, or all subsets (max. 24)",
     choice<kPlanes, &PlaneOptions::solver>(kSolvers)},
    {"planes.assignment", "choice", 0, 0,
     "how patches get their plane: expansion (graph cut, better) or icm (faster)",
     choice<kPlanes, &PlaneOptions::assignment>(kAssignments)},
    {"planes.smoothness", "1", 0, 1000,
     "w of eq. (10), the cost of a border between planes: larger gives straighter borders",
     member<kPlanes, &PlaneOptions::smoothness>},
    {"planes.triples", "count", 0, 1'000'000,
     "random triples of patches that propose a plane too: more finds planes of rough patches",
     member<kPlanes, &PlaneOptions::triples>},
    {"planes.max_hypotheses", "count", 1, 5000,
     "hypotheses kept for selection, largest support first: more is slower, by the square",
     member<kPlanes, &PlaneOptions::max_hypotheses>},
    {"planes.tabu_steps", "count", 0, 10'000'000, "moves of the tabu search: more may be better",
     member<kPlanes, &PlaneOptions::tabu_steps>},
    {"planes.random_seed", "count", 0, 0, "seed of the random triples: any whole number",
     member<kPlanes, &PlaneOptions::random_seed>},
    {"edges.concavity_tolerance", "deg", 0, 180,
     "a concave edge under this angle is ON: larger merges more",
     member<kEdges, &EdgeOptions::concavity_tolerance>},
    {"edges.smoothness_tolerance", "1", 0, 1000,
     "step allowed, in voxel sizes, beyond what the normals explain: larger merges more",
     member<kEdges, &EdgeOptions::smoothness_tolerance>},
    {"edges.singular_angle", "deg", 0, 90,
     "upper end of the sanity criterion: larger cuts more edges that touch in one place, 0 none",
     member<kEdges, &EdgeOptions::singular_angle>},
    {"edges.rim_angle", "deg", 90, 180,
     "from this angle between normals on patches are the two sides of a board: 180 switches it off",
     member<kEdges, &EdgeOptions::rim_angle>},
    {"edges.extended_convexity", "flag", 0, 0,
     "a convex edge needs a common neighbour that is convex to both: true cuts more",
     member<kEdges, &EdgeOptions::extended_convexity>},
    {"segments.min_patches", "count", 1, 1'000'000,
     "smaller segments join a neighbour: larger removes more specks",
     member<kSegments, &SegmentOptions::min_patches>},
};

}  // namespace

std::span<const OptionEntry> option_entries() { return kTable; }

}  // namespace planescope
