// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "border_points.hpp"

namespace planescope {
namespace {

// Measured on the table-top views and the synthesized rooms: boundaries are best where the distance
// along a surface counts little, but for not at all; fits to hundreds of patches are the surer
// ones.
constexpr RecutWeights kWeights = {.along = 0.1f, .stay = 0.95f};
constexpr float kOnPlane = 0.7f;  // weight of the distance to a plane or face

std::vector<PatchDisc> make_discs(const Segmentation& scene) {
  std::vector<PatchDisc> discs(scene.graph.patches.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Patch& patch = scene.graph.patches[i];
    const std::int32_t plane = scene.plane_of(i);
    discs[i] = PatchDisc::of(patch);
    if (plane == kNone) continue;
    const SupportingPlane& on = scene.planes[static_cast<std::size_t>(plane)];
    discs[i].normal = on.plane.normal;
    discs[i].center -= on.plane.signed_distance(patch.centroid) * on.plane.normal;
    discs[i].weight = kOnPlane;
    discs[i].noise = on.rms;  // else the borders of noisy walls sprinkle
  }
  return discs;
}

}  // namespace

PointPatches recut_borders(const Segmentation& scene, const PointCloud& surface) {
  const std::vector<std::uint32_t>& label = scene.segments.patch_label;
  std::vector<Adjacency> borders;
  for (const Adjacency& pair : scene.graph.adjacency) {
    if (label[pair.first] != label[pair.second]) borders.push_back(pair);
  }
  std::vector<std::uint32_t> segment;  // labels count from 1
  segment.reserve(label.size());
  for (const std::uint32_t l : label) segment.push_back(l - 1);
  PointPatches points = point_patches(scene.graph);
  recut_points(surface, points, make_discs(scene), make_neighbour_table(label.size(), borders),
               kWeights, segment);
  return points;
}

}  // namespace planescope
