// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/point_borders.hpp"

#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/patch_disc.hpp"

namespace planescope {
namespace {

// Measured on table-top views and synthesized rooms: less weight along the surface finds more of
// the true borders, but patches then reach past each other where cameras see little between them.
constexpr float kAlong = 0.3f;
constexpr float kStay = 0.9f;
constexpr float kCrease = 0.94f;  // cos 20 deg: flatter patches share a surface, and stay as grown

// Of each patch, the adjacent ones across a crease, in compressed rows.
struct Rivals {
  std::vector<std::uint32_t> offsets, patches;
};

Rivals find_rivals(const PatchGraph& graph) {
  const NeighbourTable table = make_neighbour_table(graph.patches.size(), graph.adjacency);
  Rivals rivals;
  rivals.offsets.reserve(graph.patches.size() + 1);
  rivals.offsets.push_back(0);
  for (std::size_t i = 0; i < graph.patches.size(); ++i) {
    const Eigen::Vector3f& normal = graph.patches[i].normal;
    for (std::size_t k = table.offsets[i]; k < table.offsets[i + 1]; ++k) {
      const std::uint32_t n = table.neighbours[k];
      // Normals have no sides yet.
      if (std::abs(normal.dot(graph.patches[n].normal)) < kCrease) rivals.patches.push_back(n);
    }
    rivals.offsets.push_back(static_cast<std::uint32_t>(rivals.patches.size()));
  }
  return rivals;
}

std::vector<std::uint32_t> count_points(const PatchGraph& graph) {
  std::vector<std::uint32_t> counts(graph.patches.size(), 0);
  for (const std::int32_t p : graph.point_patch) {
    if (p != kNone) ++counts[static_cast<std::size_t>(p)];
  }
  return counts;
}

// A patch of few points may lose all of them to both sides; then it gets them back.
void restore_emptied(const std::vector<std::int32_t>& before,
                     const std::vector<std::uint32_t>& counts, PatchGraph& graph) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] != kNone && counts[static_cast<std::size_t>(before[i])] == 0) {
      graph.point_patch[i] = before[i];
    }
  }
}

}  // namespace

void cut_at_creases(const PointCloud& cloud, PatchGraph& graph) {
  const Rivals rivals = find_rivals(graph);
  if (rivals.patches.empty()) return;
  std::vector<PatchDisc> discs(graph.patches.size());
  std::transform(graph.patches.begin(), graph.patches.end(), discs.begin(), PatchDisc::of);
  const std::vector<std::int32_t> before = graph.point_patch;
  const auto cut = [&](std::size_t i) {
    const auto own = static_cast<std::size_t>(before[i]);
    if (rivals.offsets[own] == rivals.offsets[own + 1]) return;
    const Eigen::Vector3f& p = cloud.positions[i];
    float least = kStay * discs[own].distance(p, kAlong);
    for (std::size_t k = rivals.offsets[own]; k < rivals.offsets[own + 1]; ++k) {
      const float distance = discs[rivals.patches[k]].distance(p, kAlong, least);
      if (distance >= least) continue;
      least = distance;
      graph.point_patch[i] = static_cast<std::int32_t>(rivals.patches[k]);
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, before.size(), 16384),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        if (before[i] != kNone) cut(i);
                      }
                    });
  std::vector<std::uint32_t> counts = count_points(graph);
  if (std::find(counts.begin(), counts.end(), 0U) != counts.end()) {
    restore_emptied(before, counts, graph);
    counts = count_points(graph);
  }
  for (std::size_t p = 0; p < counts.size(); ++p) graph.patches[p].point_count = counts[p];
}

}  // namespace planescope
