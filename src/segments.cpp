// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/segments.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "union_find.hpp"

namespace planescope {
namespace {

std::vector<std::uint32_t> component_sizes(UnionFind& sets, std::size_t patch_count) {
  std::vector<std::uint32_t> size(patch_count, 0);
  for (std::uint32_t p = 0; p < patch_count; ++p) ++size[sets.find(p)];
  return size;
}

// Joins each component of fewer than `min_patches` to the neighbour with the longest shared border
// (ties: the lower root), round by round, smallest borders of a round being measured before any
// join: the order of edges does not matter.
void merge_specks(UnionFind& sets, const PatchGraph& graph, std::uint32_t min_patches) {
  for (bool merged = true; merged;) {
    merged = false;
    const std::vector<std::uint32_t> size = component_sizes(sets, graph.patches.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> border;  // (speck, neighbour)
    for (const Adjacency& edge : graph.adjacency) {
      const std::uint32_t a = sets.find(edge.first), b = sets.find(edge.second);
      if (a == b) continue;
      if (size[a] < min_patches) border[{a, b}] += edge.border;
      if (size[b] < min_patches) border[{b, a}] += edge.border;
    }
    for (auto entry = border.begin(); entry != border.end();) {
      const std::uint32_t speck = entry->first.first;
      auto best = entry;
      for (; entry != border.end() && entry->first.first == speck; ++entry) {
        if (entry->second > best->second) best = entry;
      }
      merged |= sets.unite(speck, best->first.second);
    }
  }
}

// Which plane most of a segment's area lies on, by labels; kNone counts as one.
std::int32_t main_plane(const std::map<std::int32_t, double>& area_by_plane) {
  std::int32_t best = kNone;
  double most = -1;
  for (const auto& [plane, area] : area_by_plane) {
    if (area > most) {
      best = plane;
      most = area;
    }
  }
  return best;
}

}  // namespace

SegmentSet connect_segments(const PatchGraph& graph, const std::vector<Edge>& edges,
                            const std::vector<PatchPlane>& patch_plane,
                            const SegmentOptions& options) {
  const std::size_t patch_count = graph.patches.size();
  UnionFind sets(patch_count);
  for (const Edge& edge : edges) {
    if (edge.on) sets.unite(edge.first, edge.second);
  }
  merge_specks(sets, graph, options.min_patches);

  std::vector<std::int64_t> index(patch_count, kNone);  // by root, in the order of the first patch
  std::vector<Segment> segments;
  std::vector<Eigen::Vector3d> centroid_sum;
  std::vector<std::map<std::int32_t, double>> area_by_plane;
  SegmentSet result;
  result.patch_label.resize(patch_count);
  for (std::uint32_t p = 0; p < patch_count; ++p) {
    std::int64_t& segment = index[sets.find(p)];
    if (segment == kNone) {
      segment = static_cast<std::int64_t>(segments.size());
      segments.emplace_back();
      centroid_sum.push_back(Eigen::Vector3d::Zero());
      area_by_plane.emplace_back();
    }
    const auto s = static_cast<std::size_t>(segment);
    const Patch& patch = graph.patches[p];
    ++segments[s].patch_count;
    segments[s].point_count += patch.point_count;
    segments[s].area += patch.area;
    centroid_sum[s] += patch.point_count * patch.centroid.cast<double>();
    area_by_plane[s][patch_plane[p].plane] += double(patch.area);
    result.patch_label[p] = static_cast<std::uint32_t>(s);
  }
  std::vector<std::uint32_t> order(segments.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return segments[a].point_count > segments[b].point_count;
  });
  std::vector<std::uint32_t> label(segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t s = order[i];
    segments[s].label = label[s] = static_cast<std::uint32_t>(i + 1);
    segments[s].plane = main_plane(area_by_plane[s]);
    segments[s].centroid = (centroid_sum[s] / std::max(1u, segments[s].point_count)).cast<float>();
    result.segments.push_back(segments[s]);
  }
  for (std::uint32_t& l : result.patch_label) l = label[l];
  return result;
}

}  // namespace planescope
