// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "planescope/error.hpp"
#include "planescope/explain.hpp"
#include "union_find.hpp"

/// \file chain_between(): what joined two places, or what keeps them apart.
namespace planescope {
namespace {

constexpr std::size_t kNoEdge = std::numeric_limits<std::size_t>::max();

/// ON edges by margin, strongest first, until the two patches hang together (Kruskal): what was
/// taken so far is part of the maximum spanning forest, in which their chain is the widest.
std::vector<bool> widest_forest(const Segmentation& scene, std::uint32_t from, std::uint32_t to) {
  std::vector<std::size_t> order;
  for (std::size_t e = 0; e < scene.edges.size(); ++e)
    if (scene.edges[e].on) order.push_back(e);
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](std::size_t e) { return scene.edges[e].margin; });
  UnionFind sets(scene.graph.patches.size());
  std::vector<bool> taken(scene.edges.size(), false);
  for (const std::size_t e : order) {
    if (sets.find(from) == sets.find(to)) break;
    taken[e] = sets.unite(scene.edges[e].first, scene.edges[e].second);
  }
  if (sets.find(from) != sets.find(to)) taken.clear();
  return taken;
}

/// What a chain costs: OFF edges, the sum of their margins, then its length.
struct Cost {
  std::uint32_t off = 0;
  double margin = 0;
  std::uint32_t length = 0;
  // The zero of the comparison that the compiler writes is no pointer.
  // NOLINTNEXTLINE(modernize-use-nullptr)
  auto operator<=>(const Cost&) const = default;
};

/// Dijkstra over the edges that `usable` says; the edge by which each patch is reached.
std::vector<std::size_t> reach(const Segmentation& scene, std::uint32_t from,
                               const std::vector<bool>& usable) {
  const NeighbourTable table =
      make_neighbour_table(scene.graph.patches.size(), scene.graph.adjacency);
  constexpr Cost kFar{std::numeric_limits<std::uint32_t>::max(), 0, 0};
  std::vector<Cost> costs(scene.graph.patches.size(), kFar);
  std::vector<std::size_t> by(costs.size(), kNoEdge);
  using Entry = std::pair<Cost, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs[from] = {};
  open.push({{}, from});
  while (!open.empty()) {
    const auto [cost, patch] = open.top();
    open.pop();
    if (cost > costs[patch]) continue;
    for (std::uint32_t k = table.offsets[patch]; k < table.offsets[patch + 1]; ++k) {
      const std::size_t e = table.edges[k];
      if (!usable.empty() && !usable[e]) continue;
      const Edge& edge = scene.edges[e];
      Cost next = cost;
      ++next.length;
      if (!edge.on) ++next.off, next.margin += static_cast<double>(edge.margin);
      const std::uint32_t other = table.neighbours[k];
      if (next >= costs[other]) continue;
      costs[other] = next;
      by[other] = e;
      open.push({next, other});
    }
  }
  return by;
}

}  // namespace

Chain chain_between(const Segmentation& scene, std::uint32_t from, std::uint32_t to) {
  const std::size_t count = scene.graph.patches.size();
  const auto refuse = [&](const std::string& what) {
    throw Error(Error::Kind::Usage, "explain: " + what);
  };
  if (from >= count || to >= count)
    refuse("there is no patch " + std::to_string(std::max(from, to)) + "; the scene has " +
           std::to_string(count));
  if (from == to) refuse("both ends are patch " + std::to_string(from) + "; name two places");
  const std::vector<bool> forest = widest_forest(scene, from, to);
  const std::vector<std::size_t> by = reach(scene, from, forest);
  if (by[to] == kNoEdge)
    refuse("patches " + std::to_string(from) + " and " + std::to_string(to) +
           " lie in parts of the scene that do not touch");
  Chain chain;
  chain.joined = !forest.empty();
  chain.one_segment = scene.segments.patch_label[from] == scene.segments.patch_label[to];
  for (std::uint32_t patch = to; patch != from;) {
    const Edge& edge = scene.edges[by[patch]];
    chain.patches.push_back(patch);
    chain.edges.push_back(by[patch]);
    patch = edge.first == patch ? edge.second : edge.first;
  }
  chain.patches.push_back(from);
  std::ranges::reverse(chain.patches);
  std::ranges::reverse(chain.edges);
  return chain;
}

std::vector<std::size_t> deciding_edges(const Segmentation& scene, const Chain& chain) {
  std::vector<std::size_t> edges;
  for (const std::size_t e : chain.edges)
    if (chain.joined || !scene.edges[e].on) edges.push_back(e);
  std::ranges::stable_sort(edges, {}, [&](std::size_t e) { return scene.edges[e].margin; });
  return edges;
}

}  // namespace planescope
