// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/peer_segmentation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "planescope/error.hpp"

namespace planescope {
namespace {

/// Voxels that the points of each group occupy; group of kNone: in none.
std::vector<std::size_t> count_voxels(const PointCloud& cloud,
                                      const std::vector<std::int32_t>& group, std::size_t groups,
                                      double voxel_size) {
  using Cell = std::array<std::int32_t, 4>;
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (group[i] == kNone) continue;
    const Eigen::Vector3d at = cloud.positions[i].cast<double>() / voxel_size;
    const auto floor = [](double x) { return static_cast<std::int32_t>(std::floor(x)); };
    cells.push_back({group[i], floor(at.x()), floor(at.y()), floor(at.z())});
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<std::size_t> count(groups, 0);
  for (const Cell& cell : cells) ++count[static_cast<std::size_t>(cell[0])];
  return count;
}

/// A plane with normal n crosses (|nx| + |ny| + |nz|) / voxel_size^2 voxels a unit of area.
double area_of(std::size_t voxels, double voxel_size, double crossings) {
  return static_cast<double>(voxels) * voxel_size * voxel_size / crossings;
}

std::vector<SupportingPlane> to_planes(const PeerResult& peer, const PointCloud& cloud,
                                       double voxel_size) {
  std::vector<SupportingPlane> planes(peer.planes.size());
  if (planes.empty()) return planes;
  std::vector<double> squares(planes.size(), 0);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (peer.point_plane[i] == kNone) continue;
    const auto p = static_cast<std::size_t>(peer.point_plane[i]);
    ++planes[p].point_count;
    squares[p] += std::pow(peer.planes[p].signed_distance(cloud.positions[i]), 2);
  }
  const auto voxels = count_voxels(cloud, peer.point_plane, planes.size(), voxel_size);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    planes[p].plane = peer.planes[p];
    planes[p].hypothesis = static_cast<std::uint32_t>(p);
    planes[p].rms = static_cast<float>(std::sqrt(squares[p] / std::max(1U, planes[p].point_count)));
    planes[p].area = static_cast<float>(
        area_of(voxels[p], voxel_size, peer.planes[p].normal.cast<double>().lpNorm<1>()));
  }
  return planes;
}

/// Patches take the label of their points.
std::vector<std::uint32_t> label_patches(const PeerResult& peer) {
  std::vector<std::uint32_t> labels(peer.graph.patches.size(), kNoSegment);
  for (std::size_t i = 0; i < peer.graph.point_patch.size(); ++i) {
    const std::int32_t patch = peer.graph.point_patch[i];
    if (patch == kNone || peer.point_label[i] == kNoSegment) continue;
    labels[static_cast<std::size_t>(patch)] = peer.point_label[i];
  }
  return labels;
}

/// Counts, centroids and planes from points; areas from voxels.
std::vector<Segment> to_segments(const PeerResult& peer, const PointCloud& cloud,
                                 const std::vector<SupportingPlane>& planes, double voxel_size) {
  std::vector<Segment> segments(peer.segment_count);
  std::vector<Eigen::Vector3d> sums(segments.size(), Eigen::Vector3d::Zero());
  std::vector<std::int32_t> group(cloud.size(), kNone);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (peer.point_label[i] == kNoSegment) continue;
    const std::size_t s = peer.point_label[i] - 1;
    group[i] = static_cast<std::int32_t>(s);
    ++segments[s].point_count;
    sums[s] += cloud.positions[i].cast<double>();
    if (!planes.empty()) segments[s].plane = peer.point_plane[i];  // all of a segment or none
  }
  // Surfaces of all directions cross 1.5 voxels on average where they would cover one.
  const auto voxels = count_voxels(cloud, group, segments.size(), voxel_size);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    Segment& segment = segments[s];
    segment.label = static_cast<std::uint32_t>(s + 1);
    segment.centroid = (sums[s] / segment.point_count).cast<float>();
    segment.area = segment.plane == kNone ? static_cast<float>(area_of(voxels[s], voxel_size, 1.5))
                                          : planes[static_cast<std::size_t>(segment.plane)].area;
  }
  return segments;
}

void take_state(Edge& edge, bool on) {
  if (edge.on == on) return;
  edge.on = on;
  edge.margin = 0;
  if (on) {
    edge.rule = edge.convexity >= 0 ? EdgeRule::Convex : EdgeRule::NearlyFlat;
  } else {
    edge.rule = edge.convexity >= 0 ? EdgeRule::NoSupport : EdgeRule::Concave;
  }
}

/// The tolerances of LCCP, as classify_edges() has them.
EdgeOptions lccp_edges(const LccpOptions& options) {
  EdgeOptions edges;
  edges.concavity_tolerance = options.concavity_tolerance;
  edges.smoothness_tolerance = options.smoothness_tolerance;
  edges.singular_angle = options.sanity_criterion ? 60 : 0;
  edges.extended_convexity = options.convex_neighbours > 0;
  return edges;
}

PeerResult run_peer(std::string_view method, const PointCloud& cloud, const PeerOptions& peers) {
  if (method == "ransac") return ransac(cloud, peers.ransac);
  if (method == "lccp") return lccp(cloud, peers.lccp);
  if (method != "cpc")
    throw Error(Error::Kind::Usage,
                "method is `" + std::string(method) + "`; the peers are ransac | lccp | cpc");
  CpcOptions options = peers.cpc;
  options.lccp = peers.lccp;
  return cpc(cloud, options);
}

}  // namespace

Segmentation to_segmentation(PeerResult&& peer, const PointCloud& cloud, const Options& options,
                             const EdgeOptions& edges) {
  const double voxel_size = options.patches.voxel_size;
  Segmentation scene;
  scene.options = options;
  scene.method = {peer.method, peer.has_planes, peer.has_graph, {}};
  if (!peer.has_planes) peer.point_plane.assign(cloud.size(), kNone);
  scene.planes = to_planes(peer, cloud, voxel_size);
  scene.segments = {to_segments(peer, cloud, scene.planes, voxel_size), label_patches(peer)};
  scene.graph = std::move(peer.graph);
  scene.graph.point_patch.resize(cloud.size(), kNone);
  for (const std::uint32_t label : scene.segments.patch_label)
    if (label != kNoSegment) ++scene.segments.segments[label - 1].patch_count;
  scene.patch_plane.resize(scene.graph.patches.size());
  scene.edges = classify_edges(scene.graph, scene.patch_plane, edges);
  for (std::size_t e = 0; e < scene.edges.size(); ++e) take_state(scene.edges[e], peer.edge_on[e]);
  scene.point_label = std::move(peer.point_label);
  scene.point_plane = std::move(peer.point_plane);
  scene.times.patches = peer.times.patches;
  scene.times.segments = peer.times.segments + peer.times.labels;
  return scene;
}

Segmentation peer_segmentation(std::string_view method, const PointCloud& cloud,
                               const Options& options, const PeerOptions& peers) {
  Options stored = options;
  if (method == "ransac") {
    if (peers.ransac.voxel_size > 0) stored.patches.voxel_size = peers.ransac.voxel_size;
  } else {
    stored.patches = peers.lccp.patches;
  }
  Segmentation scene =
      to_segmentation(run_peer(method, cloud, peers), cloud, stored, lccp_edges(peers.lccp));
  scene.method.settings = peer_settings(peers, method);
  return scene;
}

}  // namespace planescope
