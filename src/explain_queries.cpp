// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <numeric>

#include "planescope/error.hpp"
#include "planescope/explain.hpp"

/// \file Which edges a question is about.
namespace planescope {
namespace {

std::vector<std::size_t> all_edges(const Segmentation& scene) {
  std::vector<std::size_t> all(scene.edges.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// The first `count` by a key, ascending; equal keys by index.
template <class Key>
std::vector<std::size_t> first_by(std::vector<std::size_t> edges, std::size_t count, Key key) {
  count = std::min(count, edges.size());
  const auto less = [&](std::size_t a, std::size_t b) {
    return std::pair(key(a), a) < std::pair(key(b), b);
  };
  std::partial_sort(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end(),
                    less);
  edges.resize(count);
  return edges;
}

void check_patch(const Segmentation& scene, std::uint32_t patch) {
  if (patch < scene.graph.patches.size()) return;
  throw Error(Error::Kind::Usage, "explain: there is no patch " + std::to_string(patch) +
                                      "; the scene has " +
                                      std::to_string(scene.graph.patches.size()));
}

}  // namespace

std::size_t find_edge(const Segmentation& scene, std::uint32_t a, std::uint32_t b) {
  check_patch(scene, a);
  check_patch(scene, b);
  const std::pair<std::uint32_t, std::uint32_t> wanted(std::min(a, b), std::max(a, b));
  const auto ends = [](const Edge& e) { return std::pair(e.first, e.second); };
  const auto found = std::ranges::lower_bound(scene.edges, wanted, {}, ends);
  if (found != scene.edges.end() && ends(*found) == wanted)
    return static_cast<std::size_t>(found - scene.edges.begin());
  std::string neighbours;
  for (const Edge& edge : scene.edges) {
    if (edge.first != a && edge.second != a) continue;
    neighbours += (neighbours.empty() ? " " : ", ") +
                  std::to_string(edge.first == a ? edge.second : edge.first);
  }
  throw Error(Error::Kind::Usage,
              "explain: patches " + std::to_string(a) + " and " + std::to_string(b) +
                  " do not touch; " +
                  (neighbours.empty() ? std::to_string(a) + " touches none"
                                      : std::to_string(a) + " touches" + neighbours));
}

std::vector<std::size_t> weakest_edges(const Segmentation& scene, std::size_t count) {
  return first_by(all_edges(scene), count, [&](std::size_t e) { return scene.edges[e].margin; });
}

std::vector<std::size_t> edges_near(const Segmentation& scene, const Eigen::Vector3f& place,
                                    std::size_t count) {
  const std::vector<Patch>& patches = scene.graph.patches;
  return first_by(all_edges(scene), count, [&](std::size_t e) {
    const Edge& edge = scene.edges[e];
    return ((patches[edge.first].centroid + patches[edge.second].centroid) / 2 - place).norm();
  });
}

SegmentEdges edges_of_segment(const Segmentation& scene, std::uint32_t label) {
  if (label == kNoSegment || label > scene.segments.segments.size())
    throw Error(Error::Kind::Usage, "explain: there is no segment " + std::to_string(label) +
                                        "; they go from 1 to " +
                                        std::to_string(scene.segments.segments.size()));
  SegmentEdges found;
  for (std::size_t e = 0; e < scene.edges.size(); ++e) {
    const Edge& edge = scene.edges[e];
    const bool first = scene.segments.patch_label[edge.first] == label;
    const bool second = scene.segments.patch_label[edge.second] == label;
    if (first && second && edge.on) found.inside.push_back(e);
    if (first != second) found.border.push_back(e);
  }
  const auto margin = [&](std::size_t e) { return scene.edges[e].margin; };
  found.inside = first_by(std::move(found.inside), scene.edges.size(), margin);
  found.border = first_by(std::move(found.border), scene.edges.size(), margin);
  return found;
}

std::uint32_t patch_at(const Segmentation& scene, const Eigen::Vector3f& place) {
  const std::vector<Patch>& patches = scene.graph.patches;
  if (patches.empty()) throw Error(Error::Kind::Usage, "explain: the scene has no patch");
  const auto distance = [&](const Patch& p) { return (p.centroid - place).squaredNorm(); };
  return static_cast<std::uint32_t>(std::ranges::min_element(patches, {}, distance) -
                                    patches.begin());
}

}  // namespace planescope
