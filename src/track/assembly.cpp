// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "segment_graph.hpp"
#include "track/tracker_state.hpp"

namespace planescope {

using track::Tile;

/// One graph of all tiles, without the points: they are many, and wait for complete(). Nothing
/// where no tile was patched since the last time.
void MapTracker::State::start_job() {
  const auto is_fresh = [](const auto& entry) { return entry.second.fresh; };
  if (std::ranges::none_of(tiles, is_fresh)) return;
  job.emplace().held_before = held;
  held.fresh.clear();
  PatchGraph& graph = job->scene.graph;
  graph.voxel_size = static_cast<float>(options.engine.patches.voxel_size);
  graph.patch_size = static_cast<float>(options.engine.patches.patch_size);
  std::map<BlockKey, std::uint32_t> first;
  for (const auto& [key, tile] : tiles) {
    if (!tile.patched) continue;
    const auto base = static_cast<std::uint32_t>(graph.patches.size());
    first[key] = base;
    const std::vector<Patch>& patches = tile.patched->graph.patches;
    graph.patches.insert(graph.patches.end(), patches.begin(), patches.end());
    for (const Adjacency& a : tile.patched->graph.adjacency) {
      graph.adjacency.push_back({a.first + base, a.second + base, a.border});
    }
    held.fresh.resize(graph.patches.size(), tile.fresh ? 1 : 0);
    job->shown.push_back(tile.patched);
  }
  // The tiles' own pairs are in order; those between tiles are few.
  const auto between = static_cast<std::ptrdiff_t>(graph.adjacency.size());
  for (const auto& [pair, borders] : joints) {
    for (const Adjacency& a : borders) {
      graph.adjacency.push_back(
          {a.first + first.at(pair.first), a.second + first.at(pair.second), a.border});
    }
  }
  const auto by_patches = [](const Adjacency& a, const Adjacency& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  };
  const auto joined = graph.adjacency.begin() + between;
  std::sort(joined, graph.adjacency.end(), by_patches);
  std::inplace_merge(graph.adjacency.begin(), joined, graph.adjacency.end(), by_patches);
  job->scene.options = options.engine;
}

/// The stages of segment_graph(), in three parts of about the same length; the first one starts the
/// job, the last one ends it. Without patches nothing is there yet, or everything is gone.
void MapTracker::State::run_stage(std::size_t stage, TrackStep& step) {
  if (stage == 0) start_job();
  if (!job) return;
  Segmentation& now = job->scene;
  const bool any = !now.graph.patches.empty();
  if (any && stage == 0) {
    find_planes(now, options.engine, {}, &held);
    assign_patches(now, options.engine);
  }
  if (any && stage == 1) held.faces = select_faces(now, options.engine.planes, &held);
  if (any && stage == 2) {
    complete_planes(now, options.engine, held.faces);
    connect_patches(now, options.engine);
  }
  if (stage == 2) book_segments(step);
}

/// The job's segmentation becomes the last one, and its segments become objects.
void MapTracker::State::book_segments(TrackStep& step) {
  step.segmented = true;
  completed = false;
  shown = std::move(job->shown);
  scene = std::move(job->scene);
  job.reset();
  patch_count = scene.graph.patches.size();
  plane_count = scene.planes.size();
  segment_count = scene.segments.segments.size();
  objects = book.match(scene.segments.segments, overlaps(), step);
  book_objects();
}

/// Tells every tile which objects its patches are; tiles without surface go.
void MapTracker::State::book_objects() {
  std::size_t patch = 0;
  for (auto entry = tiles.begin(); entry != tiles.end();) {
    Tile& tile = entry->second;
    tile.objects.clear();
    for (std::size_t p = 0; p < tile.patch_count(); ++p) {
      tile.objects.push_back(objects[scene.segments.patch_label[patch++] - 1]);
    }
    tile.fresh = false;
    tile.votes.clear();
    tile.memory.clear();
    const bool gone = tile.pieces.empty() && !tile.dirty && tile.patch_count() == 0;
    entry = gone ? tiles.erase(entry) : std::next(entry);
  }
}

/// Puts the tiles' points together, and labels them.
void MapTracker::State::complete() {
  if (completed) return;
  map = {};
  map.origin = origin.value_or(Eigen::Vector3d::Zero());
  std::int32_t base = 0;
  for (const auto& tile : shown) {
    track::append(tile->cloud, map);
    for (const std::int32_t p : tile->graph.point_patch) {
      scene.graph.point_patch.push_back(p == kNone ? kNone : p + base);
    }
    base += static_cast<std::int32_t>(tile->graph.patches.size());
  }
  map.width = static_cast<std::uint32_t>(map.size());
  label_points(scene, point_patches(scene.graph));
  completed = true;
}

/// How many points of each segment were of which object.
std::vector<track::Overlap> MapTracker::State::overlaps() {
  track::OverlapSums sums;
  std::size_t patch = 0;
  const auto add = [&](const track::Vote& vote) {
    sums.add({scene.segments.patch_label[patch] - 1, vote.object, vote.points, vote.steady});
  };
  for (auto& [key, tile] : tiles) {
    if (!tile.fresh && tile.patched && tile.steady.empty()) {
      tile.steady = track::steady_points(tile, options.steady_after);
    }
    for (std::size_t p = 0; p < tile.patch_count(); ++p, ++patch) {
      if (tile.fresh) {
        for (const track::Vote& vote : tile.votes[p]) add(vote);
      } else {
        add({tile.objects[p], tile.patched->graph.patches[p].point_count, tile.steady[p]});
      }
    }
  }
  return sums.list();
}

}  // namespace planescope
