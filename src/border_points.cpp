// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "border_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/patch_disc.hpp"

namespace planescope {
namespace {

// Measured on the table-top views and the synthesized rooms: boundaries are best where the distance
// along a surface counts little, but for not at all; fits to hundreds of patches are the surer
// ones.
constexpr float kAlong = 0.1f;    // weight of the distance beyond the patch's rim
constexpr float kOnPlane = 0.7f;  // weight of the distance to a plane or face
constexpr float kStay = 0.95f;    // weight of the distance to the patch that has the point

std::vector<PatchDisc> make_discs(const Segmentation& scene) {
  std::vector<PatchDisc> discs(scene.graph.patches.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Patch& patch = scene.graph.patches[i];
    const std::int32_t plane = scene.plane_of(i);
    discs[i] = PatchDisc::of(patch);
    if (plane == kNone) continue;
    const Plane& fit = scene.planes[static_cast<std::size_t>(plane)].plane;
    discs[i].normal = fit.normal;
    discs[i].center -= fit.signed_distance(patch.centroid) * fit.normal;
    discs[i].weight = kOnPlane;
  }
  return discs;
}

// Of each patch, the adjacent ones in other segments, in compressed rows.
struct Rivals {
  std::vector<std::uint32_t> offsets, patches;
};

Rivals find_rivals(const Segmentation& scene) {
  const std::vector<std::uint32_t>& label = scene.segments.patch_label;
  const NeighbourTable table = make_neighbour_table(label.size(), scene.graph.adjacency);
  Rivals rivals;
  rivals.offsets.reserve(label.size() + 1);
  rivals.offsets.push_back(0);
  for (std::size_t i = 0; i < label.size(); ++i) {
    for (std::size_t k = table.offsets[i]; k < table.offsets[i + 1]; ++k) {
      const std::uint32_t n = table.neighbours[k];
      if (label[n] != label[i]) rivals.patches.push_back(n);
    }
    rivals.offsets.push_back(static_cast<std::uint32_t>(rivals.patches.size()));
  }
  return rivals;
}

// A speck may lose all of its points to both sides; a segment without points is none, so it gets
// them back.
void restore_emptied(const Segmentation& scene, std::vector<std::int32_t>& point_patch) {
  const std::vector<std::int32_t>& before = scene.graph.point_patch;
  const auto label_of = [&](std::int32_t p) {
    return scene.segments.patch_label[static_cast<std::size_t>(p)];
  };
  std::vector<std::uint8_t> holds(scene.segments.segments.size() + 1, 0);
  for (const std::int32_t p : point_patch) {
    if (p != kNone) holds[label_of(p)] = 1;
  }
  if (std::find(holds.begin() + 1, holds.end(), 0) == holds.end()) return;
  for (std::size_t i = 0; i < point_patch.size(); ++i) {
    if (before[i] != kNone && holds[label_of(before[i])] == 0) point_patch[i] = before[i];
  }
}

}  // namespace

std::vector<std::int32_t> recut_borders(const Segmentation& scene, const PointCloud& surface) {
  const std::vector<PatchDisc> discs = make_discs(scene);
  const Rivals rivals = find_rivals(scene);
  std::vector<std::int32_t> point_patch = scene.graph.point_patch;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, point_patch.size(), 16384), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          if (point_patch[i] == kNone) continue;
          const auto own = static_cast<std::size_t>(point_patch[i]);
          if (rivals.offsets[own] == rivals.offsets[own + 1]) continue;
          const Eigen::Vector3f& p = surface.positions[i];
          float least = kStay * discs[own].distance(p, kAlong);
          for (std::size_t k = rivals.offsets[own]; k < rivals.offsets[own + 1]; ++k) {
            const std::uint32_t rival = rivals.patches[k];
            const float distance = discs[rival].distance(p, kAlong, least);
            if (distance >= least) continue;
            least = distance;
            point_patch[i] = static_cast<std::int32_t>(rival);
          }
        }
      });
  restore_emptied(scene, point_patch);
  return point_patch;
}

}  // namespace planescope
