// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <numeric>

#include "planescope/patches.hpp"

namespace planescope {

NeighbourTable make_neighbour_table(std::size_t patch_count,
                                    const std::vector<Adjacency>& adjacency) {
  NeighbourTable table;
  table.offsets.assign(patch_count + 1, 0);
  for (const Adjacency& edge : adjacency) {
    ++table.offsets[edge.first + std::size_t{1}];
    ++table.offsets[edge.second + std::size_t{1}];
  }
  std::partial_sum(table.offsets.begin(), table.offsets.end(), table.offsets.begin());
  table.neighbours.resize(2 * adjacency.size());
  table.edges.resize(2 * adjacency.size());
  std::vector<std::uint32_t> next(table.offsets.begin(), table.offsets.end() - 1);
  const auto add = [&](std::uint32_t row, std::uint32_t neighbour, std::size_t edge) {
    table.neighbours[next[row]] = neighbour;
    table.edges[next[row]++] = static_cast<std::uint32_t>(edge);
  };
  // Sorted edges, smaller neighbours first: rows come out ascending.
  for (std::size_t e = 0; e < adjacency.size(); ++e)
    add(adjacency[e].second, adjacency[e].first, e);
  for (std::size_t e = 0; e < adjacency.size(); ++e)
    add(adjacency[e].first, adjacency[e].second, e);
  return table;
}

}  // namespace planescope
