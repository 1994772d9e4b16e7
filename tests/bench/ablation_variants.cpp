// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ablation_variants.hpp"

#include <cmath>
#include <utility>

#include "border_points.hpp"
#include "patches/smoothing.hpp"
#include "planes/energy.hpp"
#include "planes/hypotheses.hpp"
#include "planes/labelling.hpp"
#include "planes/shared_directions.hpp"
#include "planes/support.hpp"
#include "segment_graph.hpp"

namespace planescope::bench {
namespace {

PointCloud smoothed(const PointCloud& cloud, const PatchOptions& options) {
  return options.smoothing > 0 ? smooth_points(cloud, options.smoothing) : cloud;
}

bool same_patches(const Options& a, const Options& b) {
  for (const OptionInfo& info : option_table()) {
    if (info.name.starts_with("patches.") && get_option(a, info.name) != get_option(b, info.name))
      return false;
  }
  return true;
}

Options options_of(const AblationScene& scene, const Variant& variant) {
  Options options = scene.options;
  if (variant.parts.fixed_preset)
    options = scene.is_tabletop ? Options::tabletop() : Options::room();
  for (const auto& [name, value] : variant.settings) set_option(options, name, value);
  return options;
}

// Selection by eq. (4) as it is printed, exp((lambda - |I|) / lambda), which is never negative.
PlaneSelection select_as_printed(const PatchGraph& graph, const PlaneOptions& options) {
  PlaneSelection selection;
  selection.lambda = support_threshold(graph.patches, options.min_area);
  const PatchIndex index(graph.patches);
  const Hypotheses found = propose_hypotheses(index, options, selection.lambda);
  SelectionEnergy energy =
      selection_energy(found.kept, pair_terms(found.kept, index, graph, options), selection.lambda);
  for (std::size_t m = 0; m < energy.size(); ++m) {
    energy.unary[m] = std::exp(1 - found.kept[m].support / selection.lambda);
    selection.hypotheses.push_back({.plane = found.kept[m].plane});
  }
  const std::vector<bool> x = minimise_selection(energy, options.solver, options.tabu_steps);
  for (std::uint32_t m = 0; m < x.size(); ++m) {
    if (x[m]) selection.selected.push_back(m);
  }
  return selection;
}

// Eq. (10) as it is printed: neighbours pay where their labels are equal. No graph cut minimises
// that.
std::vector<std::int32_t> assign_as_printed(const PatchGraph& graph,
                                            const std::vector<Plane>& planes,
                                            const PlaneOptions& options) {
  LabellingProblem problem = make_labelling_problem(graph, planes, options);
  problem.potts = -problem.potts;
  return relax_labels(problem, cheapest_labels(problem));
}

// The stages of segment_graph(), but for those parts.
void segment_without(Segmentation& scene, const Options& options, const Parts& parts) {
  scene.selection = parts.printed_data_cost ? select_as_printed(scene.graph, options.planes)
                                            : select_planes(scene.graph, options.planes);
  std::vector<Plane> planes;
  for (const std::uint32_t s : scene.selection.selected)
    planes.push_back(scene.selection.hypotheses[s].plane);
  const std::vector<std::int32_t> assignment =
      parts.printed_assignment ? assign_as_printed(scene.graph, planes, options.planes)
                               : assign_planes(scene.graph, planes, options.planes);
  Support support = refit_planes(scene.graph, scene.selection, assignment);
  scene.planes = std::move(support.planes);
  scene.patch_plane = std::move(support.patch_plane);
  if (!parts.refit) {
    for (SupportingPlane& plane : scene.planes)
      plane.plane = scene.selection.hypotheses[plane.hypothesis].plane;
  }
  add_faces(scene, options.planes, select_faces(scene, options.planes));
  DirectionTolerance tolerance = direction_tolerance(options);
  if (!parts.shared_directions) tolerance.angle = 0;
  settle_planes(scene, options.planes, tolerance);
  scene.edges = classify_edges(scene.graph, scene.patch_plane, options.edges);
  scene.segments = connect_segments(scene.graph, scene.edges, scene.patch_plane, options.segments);
}

bool needs_other_stages(const Parts& p) {
  return p.printed_data_cost || p.printed_assignment || !p.refit || !p.shared_directions;
}

}  // namespace

AblationScene prepare(std::string name, PointCloud cloud, std::vector<TruePlane> planes) {
  AblationScene scene;
  scene.name = std::move(name);
  scene.cloud = std::move(cloud);
  scene.planes = std::move(planes);
  scene.options = Options::automatic(scene.cloud);
  scene.surface = smoothed(scene.cloud, scene.options.patches);
  scene.graph = make_patches(scene.surface, scene.options.patches);
  return scene;
}

const std::vector<Variant>& variants() {
  static const std::vector<Variant> kVariants = {
      {"full method"},
      {"no overlap term in eq. (6)", {{"planes.weight_overlap", "0"}}},
      {"no angle term in eq. (6), directions not shared", {{"planes.weight_angle", "0"}}},
      {"angle term of touching planes only", {{"planes.angle_scope", "touching"}}},
      {"no normal gate", {{"planes.normal_gate", "0"}}},
      {"eq. (4) as printed", {}, {.printed_data_cost = true}},
      {"eq. (10) as printed", {}, {.printed_assignment = true}},
      {"LSA-TR alone", {{"planes.solver", "lsa_tr"}}},
      {"ICM instead of expansion", {{"planes.assignment", "icm"}}},
      {"no refit of supporting planes, directions not shared",
       {},
       {.refit = false, .shared_directions = false}},
      {"directions not shared", {}, {.shared_directions = false}},
      {"no faces", {{"planes.face_area", "0"}}},
      {"no smoothing of scattered maps", {{"patches.smoothing", "0"}}},
      {"voxels of one size in views", {{"patches.range_exponent", "0"}}},
      {"borders along patches", {}, {.border_points = false}},
      {"no rim rule", {{"edges.rim_angle", "180"}}},
      {"sanity criterion up to 60 deg, as in LCCP", {{"edges.singular_angle", "60"}}},
      {"steps of 0.1 voxel, as in LCCP", {{"edges.smoothness_tolerance", "0.1"}}},
      {"extended convexity, as in LCCP", {{"edges.extended_convexity", "true"}}},
      {"specks stay", {{"segments.min_patches", "1"}}},
      {"fixed presets instead of `auto`", {}, {.fixed_preset = true}},
  };
  return kVariants;
}

Segmentation run(const AblationScene& scene, const Variant& variant) {
  Segmentation result;
  result.options = options_of(scene, variant);
  const bool known = same_patches(result.options, scene.options);
  const PointCloud other = known ? PointCloud() : smoothed(scene.cloud, result.options.patches);
  const PointCloud& surface = known ? scene.surface : other;
  result.graph = known ? scene.graph : make_patches(surface, result.options.patches);
  if (needs_other_stages(variant.parts)) {
    segment_without(result, result.options, variant.parts);
  } else {
    segment_graph(result, result.options);
  }
  label_points(result, variant.parts.border_points ? recut_borders(result, surface)
                                                   : point_patches(result.graph));
  return result;
}

}  // namespace planescope::bench
