// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/creases.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "patches/recut_points.hpp"

namespace planescope {
namespace {

// Measured on table-top views and synthesized rooms: less weight along the surface finds more of
// the true borders, but patches then reach past each other where cameras see little between them.
constexpr RecutWeights kWeights = {.along = 0.3f, .stay = 0.9f};
constexpr float kCrease = 0.94f;  // cos 20 deg: flatter patches share a surface, and stay as grown

}  // namespace

void cut_at_creases(const PointCloud& cloud, PatchGraph& graph) {
  const std::vector<Patch>& patches = graph.patches;
  std::vector<Adjacency> creases;
  for (const Adjacency& pair : graph.adjacency) {
    // Normals have no sides yet.
    const float cosine = std::abs(patches[pair.first].normal.dot(patches[pair.second].normal));
    if (cosine < kCrease) creases.push_back(pair);
  }
  std::vector<PatchDisc> discs(patches.size());
  std::transform(patches.begin(), patches.end(), discs.begin(), PatchDisc::of);
  std::vector<std::uint32_t> itself(patches.size());
  std::iota(itself.begin(), itself.end(), 0U);
  PointPatches points = point_patches(graph);
  recut_points(cloud, points, discs, make_neighbour_table(patches.size(), creases), kWeights,
               itself);
  graph.point_patch = std::move(points.patch);
  for (std::size_t p = 0; p < points.count.size(); ++p)
    graph.patches[p].point_count = points.count[p];
}

}  // namespace planescope
