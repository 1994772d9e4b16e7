// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "segment_graph.hpp"
#include "track/tracker_state.hpp"

namespace planescope {

/// One graph of all tiles, without the points: they are many, and wait for complete().
void MapTracker::State::assemble() {
  completed = false;
  point_count = 0;
  PatchGraph graph;
  graph.voxel_size = static_cast<float>(options.engine.patches.voxel_size);
  graph.patch_size = static_cast<float>(options.engine.patches.patch_size);
  std::map<BlockKey, std::uint32_t> first;
  for (const auto& [key, tile] : tiles) {
    const auto base = static_cast<std::uint32_t>(graph.patches.size());
    first[key] = base;
    const auto add = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    add(graph.patches, tile.graph.patches);
    for (const Adjacency& a : tile.graph.adjacency) {
      graph.adjacency.push_back({a.first + base, a.second + base, a.border});
    }
    point_count += tile.cloud.size();
  }
  for (const auto& [pair, borders] : joints) {
    for (const Adjacency& a : borders) {
      graph.adjacency.push_back(
          {a.first + first.at(pair.first), a.second + first.at(pair.second), a.border});
    }
  }
  std::ranges::sort(graph.adjacency, [](const Adjacency& a, const Adjacency& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  scene.graph = std::move(graph);
}

void MapTracker::State::segment_map() {
  PatchGraph graph = std::move(scene.graph);
  scene = {};
  scene.options = options.engine;
  scene.graph = std::move(graph);
  // Else nothing is there yet, or everything is gone.
  if (!scene.graph.patches.empty()) segment_graph(scene, options.engine);
}

/// Puts the tiles' points together, and labels them.
void MapTracker::State::complete() {
  if (completed) return;
  map = {};
  map.origin = origin.value_or(Eigen::Vector3d::Zero());
  std::int32_t base = 0;
  for (const auto& [key, tile] : tiles) {
    const auto add = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    add(map.positions, tile.cloud.positions);
    add(map.normals, tile.cloud.normals);
    add(map.colors, tile.cloud.colors);
    for (const std::int32_t p : tile.graph.point_patch) {
      scene.graph.point_patch.push_back(p == kNone ? kNone : p + base);
    }
    base += static_cast<std::int32_t>(tile.graph.patches.size());
  }
  map.width = static_cast<std::uint32_t>(map.size());
  label_points(scene, scene.graph.point_patch);
  completed = true;
}

/// How many points of each segment were of which object.
std::vector<track::Overlap> MapTracker::State::overlaps() const {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sums;
  std::size_t patch = 0;
  for (const auto& [key, tile] : tiles) {
    for (const auto& votes : tile.votes) {
      const std::uint32_t segment = scene.segments.patch_label[patch++] - 1;
      for (const auto& [object, points] : votes) sums[{segment, object}] += points;
    }
  }
  std::vector<track::Overlap> list;
  for (const auto& [pair, points] : sums) list.push_back({pair.first, pair.second, points});
  return list;
}

}  // namespace planescope
