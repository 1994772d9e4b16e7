// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "union_find.hpp"

namespace planescope {
namespace {

// Cosine between the first patch's normal, mirrored in the plane between the two, and the second's.
float agreement(const Patch& a, const Patch& b) {
  const Eigen::Vector3f d = b.centroid - a.centroid;
  const float length = d.squaredNorm();
  if (length == 0) return a.normal.dot(b.normal);
  return (a.normal - 2 * a.normal.dot(d) / length * d).dot(b.normal);
}

// Edges of a maximum spanning forest by |agreement|, as indices into the adjacency.
std::vector<std::uint32_t> surest_forest(const PatchGraph& graph,
                                         const std::vector<float>& agreements) {
  std::vector<std::uint32_t> order(graph.adjacency.size()), forest;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::abs(agreements[a]) > std::abs(agreements[b]);
  });
  UnionFind sets(graph.patches.size());
  for (const std::uint32_t e : order) {
    if (sets.unite(graph.adjacency[e].first, graph.adjacency[e].second)) forest.push_back(e);
  }
  std::sort(forest.begin(), forest.end());
  return forest;
}

Eigen::Vector3f area_centroid(const std::vector<Patch>& patches) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const Patch& patch : patches) {
    sum += double(patch.area) * patch.centroid.cast<double>();
    area += double(patch.area);
  }
  return (sum / std::max(area, std::numeric_limits<double>::min())).cast<float>();
}

}  // namespace

void orient_towards(std::vector<Patch>& patches, const Eigen::Vector3f& sensor) {
  for (Patch& patch : patches) {
    if (patch.normal.dot(sensor - patch.centroid) < 0) patch.normal = -patch.normal;
  }
}

void orient_by_votes(std::vector<Patch>& patches, const std::vector<Eigen::Vector3f>& votes) {
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patches[i].normal.dot(votes[i]) < 0) patches[i].normal = -patches[i].normal;
  }
}

void orient_consistently(PatchGraph& graph) {
  std::vector<Patch>& patches = graph.patches;
  std::vector<float> agreements(graph.adjacency.size());
  for (std::size_t e = 0; e < agreements.size(); ++e) {
    agreements[e] =
        agreement(patches[graph.adjacency[e].first], patches[graph.adjacency[e].second]);
  }
  std::vector<Adjacency> tree;
  std::vector<float> tree_agreement;
  for (const std::uint32_t e : surest_forest(graph, agreements)) {
    tree.push_back(graph.adjacency[e]);
    tree_agreement.push_back(agreements[e]);
  }
  const NeighbourTable table = make_neighbour_table(patches.size(), tree);
  const Eigen::Vector3f middle = area_centroid(patches);
  std::vector<std::int8_t> sign(patches.size(), 0);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t root = 0; root < patches.size(); ++root) {
    if (sign[root] != 0) continue;
    sign[root] = 1;
    piece.assign(1, root);
    double inwards = 0;  // area that faces the scene's middle, less that which faces away
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::uint32_t i = piece[next];
      const float facing = patches[i].normal.dot(middle - patches[i].centroid);
      inwards += (facing * float(sign[i]) < 0 ? -1 : 1) * double(patches[i].area);
      for (std::size_t k = table.offsets[i]; k < table.offsets[i + std::size_t{1}]; ++k) {
        const std::uint32_t n = table.neighbours[k];
        if (sign[n] != 0) continue;
        sign[n] = static_cast<std::int8_t>(tree_agreement[table.edges[k]] < 0 ? -sign[i] : sign[i]);
        piece.push_back(n);
      }
    }
    for (const std::uint32_t i : piece) {
      if ((sign[i] < 0) != (inwards < 0)) patches[i].normal = -patches[i].normal;
    }
  }
}

}  // namespace planescope
