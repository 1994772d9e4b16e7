// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// Only PCL's precompiled instantiations may be used here: the octree containers of
// SupervoxelClustering<PointXYZRGBA> have specialised members that live in libpcl_segmentation
// alone, and an instantiation of ours would replace them by the empty generic ones, without a
// word.
#ifdef PCL_NO_PRECOMPILE
#error "build without PCL_NO_PRECOMPILE: see above"
#endif
#include <pcl/console/print.h>
#include <pcl/segmentation/cpc_segmentation.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "baselines/baselines.hpp"
#include "baselines/deep_stack.hpp"
#include "baselines/peer_input.hpp"
#include "baselines/voxel_graph.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using Point = pcl::PointXYZRGBA;
using Clusters = std::map<std::uint32_t, pcl::Supervoxel<Point>::Ptr>;
using Neighbours = std::multimap<std::uint32_t, std::uint32_t>;
using Lccp = pcl::LCCPSegmentation<Point>;

/// PCL prints progress to stdout, which belongs to whoever called us.
class QuietPcl {
 public:
  QuietPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(before_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL before_ = pcl::console::getVerbosityLevel();
};

/// A cloud as PCL wants it: finite points only, the sensor in (0,0,0), where PCL takes it to be.
struct PclInput {
  std::vector<std::uint32_t> finite;  ///< index of each point in our cloud
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  pcl::PointCloud<Point>::Ptr points{new pcl::PointCloud<Point>};
  pcl::PointCloud<pcl::Normal>::Ptr normals;  ///< null: PCL makes its own
};

void check(const PatchOptions& options) {
  if (!(options.voxel_size > 0) || !(options.patch_size > options.voxel_size))
    throw Error(Error::Kind::Usage, "voxel_size " + std::to_string(options.voxel_size) +
                                        " m, patch_size " + std::to_string(options.patch_size) +
                                        " m: expected 0 < voxel_size < patch_size");
}

pcl::PointCloud<pcl::Normal>::Ptr pcl_normals(const PointCloud& cloud,
                                              const std::vector<std::uint32_t>& finite) {
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  normals->resize(finite.size());
  bool any = false;
  for (std::size_t i = 0; i < finite.size(); ++i) {
    const Eigen::Vector3f& n = cloud.normals[finite[i]];
    any = any || is_finite(n);
    // PCL sums a voxel's normals: an unknown one must add nothing.
    (*normals)[i].getNormalVector3fMap() = is_finite(n) ? n : Eigen::Vector3f::Zero();
    (*normals)[i].curvature = 0;
  }
  return any ? normals : nullptr;
}

PclInput to_pcl(const PointCloud& cloud, const PatchOptions& options) {
  check(options);
  PclInput input;
  input.finite = finite_points(cloud);
  check_extent(cloud, input.finite, options.voxel_size);
  if (cloud.sensor && is_finite(*cloud.sensor)) input.shift = *cloud.sensor;
  input.points->resize(input.finite.size());
  for (std::size_t i = 0; i < input.finite.size(); ++i) {
    Point& point = (*input.points)[i];
    point.getVector3fMap() = cloud.positions[input.finite[i]] - input.shift;
    const Rgb color = cloud.has_colors() ? cloud.colors[input.finite[i]] : Rgb{};
    point.r = color.r, point.g = color.g, point.b = color.b, point.a = 255;
  }
  if (cloud.has_normals()) input.normals = pcl_normals(cloud, input.finite);
  return input;
}

/// PCL's supervoxels, their adjacency, and the label of every finite point.
struct Supervoxels {
  Supervoxels(const PclInput& input, const PatchOptions& options)
      : clustering(static_cast<float>(options.voxel_size), static_cast<float>(options.patch_size)) {
    clustering.setUseSingleCameraTransform(false);  // on by itself for organised clouds otherwise
    clustering.setInputCloud(input.points);
    if (input.normals) clustering.setNormalCloud(input.normals);
    clustering.setColorImportance(static_cast<float>(options.weight_color));
    clustering.setSpatialImportance(static_cast<float>(options.weight_spatial));
    clustering.setNormalImportance(static_cast<float>(options.weight_normal));
    clustering.extract(clusters);
    clustering.getSupervoxelAdjacency(neighbours);
  }

  pcl::SupervoxelClustering<Point> clustering;
  Clusters clusters;
  Neighbours neighbours;
};

/// PCL's supervoxels as our graph: ids in the order of PCL's labels. A supervoxel that lost its
/// last voxel to others has no point, and no id.
struct NumberedGraph {
  PatchGraph graph;
  std::map<std::uint32_t, std::uint32_t> id;  ///< of PCL's label
};

NumberedGraph to_graph(const Supervoxels& made, const pcl::PointCloud<pcl::PointXYZL>& labelled,
                       const PclInput& input, std::size_t point_count,
                       const PatchOptions& options) {
  NumberedGraph result;
  auto& [graph, id] = result;
  graph.voxel_size = static_cast<float>(options.voxel_size);
  graph.patch_size = static_cast<float>(options.patch_size);
  for (const auto& point : labelled)
    if (made.clusters.contains(point.label)) id[point.label] = 0;
  for (auto& [label, number] : id) {
    number = static_cast<std::uint32_t>(graph.patches.size());
    const Eigen::Vector3f normal = made.clusters.at(label)->normal_.getNormalVector3fMap();
    const bool known = is_finite(normal) && normal.norm() > 0.5F;
    graph.patches.emplace_back().normal = known ? normal.normalized() : Eigen::Vector3f::UnitZ();
  }
  std::vector<Eigen::Vector3f> points;
  std::vector<Rgb> colors;
  std::vector<std::int32_t> patch(labelled.size(), kNone);
  graph.point_patch.assign(point_count, kNone);
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const Point& point = (*input.points)[i];
    points.emplace_back(point.getVector3fMap());
    colors.push_back({point.r, point.g, point.b});
    const auto at = id.find(labelled[i].label);
    if (at == id.end()) continue;
    graph.point_patch[input.finite[i]] = patch[i] = static_cast<std::int32_t>(at->second);
    ++graph.patches[at->second].point_count;
  }
  const auto voxel_size = static_cast<double>(graph.voxel_size);  // PCL keeps it as float
  const PatchVoxels voxels = make_voxels(points, colors, patch, voxel_size);
  measure_patches(voxels, graph.patches);
  for (Patch& each : graph.patches) each.centroid += input.shift;
  graph.adjacency = find_borders(voxels);
  return result;
}

/// LCCP or CPC, with its graph's vertices in the order of the supervoxels' labels. PCL's boost
/// graph orders them by address, so that merging small segments, and the samples of CPC's RANSAC,
/// would change from run to run.
template <typename Method>
class InLabelOrder : public Method {
 public:
  void order(const Clusters& clusters, const Neighbours& neighbours) {
    auto& graph = this->Lccp::sv_adjacency_list_;
    graph.clear();
    for (std::size_t i = 0; i < clusters.size(); ++i) boost::add_vertex(graph);
    std::map<std::uint32_t, Lccp::VertexID> vertex;
    auto label = clusters.begin();
    for (auto [at, end] = boost::vertices(graph); at != end; ++at, ++label) {
      graph[*at] = label->first;
      vertex.emplace(label->first, *at);
    }
    for (const auto& [from, to] : neighbours)
      boost::add_edge(vertex.at(from), vertex.at(to), graph);
  }

  /// Per adjacency of the graph: whether PCL joins the two patches directly.
  std::vector<bool> edges_on(const NumberedGraph& made) const {
    std::set<std::pair<std::uint32_t, std::uint32_t>> on;
    const auto& graph = this->Lccp::sv_adjacency_list_;
    for (auto [at, end] = boost::edges(graph); at != end; ++at) {
      const auto a = made.id.find(graph[boost::source(*at, graph)]);
      const auto b = made.id.find(graph[boost::target(*at, graph)]);
      if (graph[*at].is_valid && a != made.id.end() && b != made.id.end())
        on.insert(std::minmax(a->second, b->second));
    }
    std::vector<bool> result;
    for (const Adjacency& pair : made.graph.adjacency)
      result.push_back(on.contains({pair.first, pair.second}));
    return result;
  }
};

template <typename Method>
PeerResult run(const PointCloud& cloud, const LccpOptions& options, Method& method,
               const char* name) {
  const QuietPcl quiet;
  PeerResult result;
  result.method = name;
  result.point_label.assign(cloud.size(), kNoSegment);
  Lap lap;
  const PclInput input = to_pcl(cloud, options.patches);
  result.times.convert += lap();
  Supervoxels made(input, options.patches);
  result.times.patches = lap();
  method.setConcavityToleranceThreshold(static_cast<float>(options.concavity_tolerance));
  method.setSmoothnessCheck(true, static_cast<float>(options.patches.voxel_size),
                            static_cast<float>(options.patches.patch_size),
                            static_cast<float>(options.smoothness_tolerance));
  method.setSanityCheck(options.sanity_criterion);
  method.setKFactor(options.convex_neighbours);
  method.setMinSegmentSize(options.min_patches);
  method.setInputSupervoxels(made.clusters, made.neighbours);
  result.times.segments = lap();
  method.order(made.clusters, made.neighbours);
  result.times.convert += lap();
  constexpr std::size_t kFrame = 1024, kBase = 16 << 20;  // generous: a frame is a few 100 bytes
  run_with_stack(kBase + kFrame * made.clusters.size(), [&] { method.segment(); });
  result.times.segments += lap();
  pcl::PointCloud<pcl::PointXYZL>::Ptr labelled = made.clustering.getLabeledCloud();
  result.times.labels = lap();
  if (options.keep_graph) {
    result.has_graph = true;
    NumberedGraph numbered = to_graph(made, *labelled, input, cloud.size(), options.patches);
    result.edge_on = method.edges_on(numbered);
    result.graph = std::move(numbered.graph);
  }
  result.times.convert += lap();
  method.relabelCloud(*labelled);
  result.times.labels += lap();
  for (std::size_t i = 0; i < labelled->size(); ++i)
    result.point_label[input.finite[i]] = (*labelled)[i].label;
  result.segment_count = rank_labels(result.point_label);
  result.times.convert += lap();
  return result;
}

}  // namespace

PatchGraph pcl_patches(const PointCloud& cloud, const PatchOptions& options) {
  const QuietPcl quiet;
  const PclInput input = to_pcl(cloud, options);
  const Supervoxels made(input, options);
  return to_graph(made, *made.clustering.getLabeledCloud(), input, cloud.size(), options).graph;
}

PeerResult lccp(const PointCloud& cloud, const LccpOptions& options) {
  InLabelOrder<Lccp> method;
  return run(cloud, options, method, "lccp");
}

PeerResult cpc(const PointCloud& cloud, const CpcOptions& options) {
  InLabelOrder<pcl::CPCSegmentation<Point>> method;
  method.setCutting(options.max_cuts, options.min_edges, static_cast<float>(options.min_score),
                    options.local, options.directed, options.clean);
  method.setRANSACIterations(options.ransac_iterations);
  return run(cloud, options.lccp, method, "cpc");
}

}  // namespace planescope
