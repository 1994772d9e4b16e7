// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// Only PCL's precompiled instantiations: see supervoxels.cpp.
#include <pcl/console/print.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "baselines/baselines.hpp"
#include "baselines/peer_input.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// The cloud as RANSAC sees it: voxel means, or the finite points themselves.
struct Thinned {
  Cloud::Ptr points{new Cloud};
  std::vector<std::uint32_t> of_finite;  ///< per finite point: index into `points`
};

void check(const RansacOptions& options) {
  const bool sane = options.voxel_size >= 0 && options.threshold > 0 &&
                    options.cluster_tolerance > 0 && options.min_plane_share > 0 &&
                    options.min_plane_share <= 1 && options.max_iterations > 0;
  if (!sane)
    throw Error(Error::Kind::Usage,
                "ransac: expected voxel_size >= 0, threshold > 0, cluster_tolerance > 0, "
                "max_iterations > 0 and 0 < min_plane_share <= 1");
}

pcl::PointXYZ to_pcl(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

/// Means over the cells of a grid; finite points in order of their cells.
void thin(const PointCloud& cloud, const std::vector<std::uint32_t>& finite, double voxel_size,
          Thinned& thinned) {
  using Cell = std::array<std::int64_t, 3>;
  std::vector<std::pair<Cell, std::uint32_t>> order(finite.size());
  for (std::uint32_t i = 0; i < finite.size(); ++i) {
    const Eigen::Vector3d at = cloud.positions[finite[i]].cast<double>() / voxel_size;
    order[i] = {{static_cast<std::int64_t>(std::floor(at.x())),
                 static_cast<std::int64_t>(std::floor(at.y())),
                 static_cast<std::int64_t>(std::floor(at.z()))},
                i};
  }
  std::sort(order.begin(), order.end());
  thinned.of_finite.resize(finite.size());
  for (std::size_t from = 0; from < order.size();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t to = from;
    for (; to < order.size() && order[to].first == order[from].first; ++to) {
      sum += cloud.positions[finite[order[to].second]].cast<double>();
      thinned.of_finite[order[to].second] = static_cast<std::uint32_t>(thinned.points->size());
    }
    thinned.points->push_back(to_pcl((sum / static_cast<double>(to - from)).cast<float>()));
    from = to;
  }
}

Thinned thinned_cloud(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                      double voxel_size) {
  Thinned thinned;
  if (voxel_size > 0) {
    thin(cloud, finite, voxel_size, thinned);
  } else {
    for (const std::uint32_t i : finite) thinned.points->push_back(to_pcl(cloud.positions[i]));
    thinned.of_finite.resize(finite.size());
    std::iota(thinned.of_finite.begin(), thinned.of_finite.end(), 0U);
  }
  return thinned;
}

/// PCL's own generator always starts at 12345: what is drawn changes with the order of the indices,
/// so that is what we seed. Fisher-Yates on mt19937_64, the same everywhere (std::shuffle is not).
pcl::Indices shuffled(std::size_t count, std::uint64_t seed) {
  pcl::Indices indices(count);
  std::iota(indices.begin(), indices.end(), 0);
  std::mt19937_64 random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(indices[i - 1], indices[random() % i]);
  return indices;
}

Plane to_plane(const pcl::ModelCoefficients& model, const PointCloud& cloud) {
  const Eigen::Vector3f normal(model.values[0], model.values[1], model.values[2]);
  Plane plane{normal / normal.norm(), -model.values[3] / normal.norm()};
  Eigen::Index largest = 0;
  plane.normal.cwiseAbs().maxCoeff(&largest);
  const bool flip =
      cloud.sensor ? plane.signed_distance(*cloud.sensor) < 0 : plane.normal[largest] < 0;
  if (flip) plane = {-plane.normal, -plane.distance};
  return plane;
}

/// Takes planes off `rest` while they are large enough; `label` gets 1, 2, ...
void take_planes(const PointCloud& cloud, const Cloud::Ptr& points, const RansacOptions& options,
                 pcl::Indices& rest, std::vector<std::uint32_t>& label,
                 std::vector<Plane>& planes) {
  pcl::SACSegmentation<pcl::PointXYZ> sac;  // unseeded constructor: always the same draws
  sac.setModelType(pcl::SACMODEL_PLANE);
  sac.setMethodType(pcl::SAC_RANSAC);
  sac.setDistanceThreshold(options.threshold);
  sac.setMaxIterations(static_cast<int>(options.max_iterations));
  sac.setOptimizeCoefficients(true);
  sac.setInputCloud(points);
  const double least = std::max(3.0, options.min_plane_share * static_cast<double>(points->size()));
  while (static_cast<double>(rest.size()) >= least) {
    sac.setIndices(pcl::IndicesConstPtr(new pcl::Indices(rest)));
    pcl::PointIndices inliers;
    pcl::ModelCoefficients model;
    sac.segment(inliers, model);
    if (static_cast<double>(inliers.indices.size()) < least) break;
    planes.push_back(to_plane(model, cloud));
    for (const int i : inliers.indices)
      label[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(planes.size());
    std::erase_if(rest, [&](int i) { return label[static_cast<std::size_t>(i)] != kNoSegment; });
  }
}

void cluster_rest(const Cloud::Ptr& points, const RansacOptions& options, pcl::Indices& rest,
                  std::uint32_t next_label, std::vector<std::uint32_t>& label) {
  if (rest.empty()) return;
  std::sort(rest.begin(), rest.end());
  Cloud::Ptr left(new Cloud(*points, rest));
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(left);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(options.cluster_tolerance);
  extraction.setMinClusterSize(options.min_cluster_size);
  extraction.setMaxClusterSize(std::numeric_limits<int>::max());
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(left);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  for (const pcl::PointIndices& cluster : clusters) {
    for (const int i : cluster.indices)
      label[static_cast<std::size_t>(rest[static_cast<std::size_t>(i)])] = next_label;
    ++next_label;
  }
}

}  // namespace

PeerResult ransac(const PointCloud& cloud, const RansacOptions& options) {
  check(options);
  const std::vector<std::uint32_t> finite = finite_points(cloud);
  check_extent(cloud, finite,
               options.voxel_size > 0 ? options.voxel_size : options.cluster_tolerance);
  const auto verbosity = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  PeerResult result;
  result.method = "ransac";
  Lap lap;
  const Thinned thinned = thinned_cloud(cloud, finite, options.voxel_size);
  result.times.patches = lap();
  std::vector<std::uint32_t> label(thinned.points->size(), kNoSegment);
  pcl::Indices rest = shuffled(thinned.points->size(), options.random_seed);
  take_planes(cloud, thinned.points, options, rest, label, result.planes);
  const auto plane_count = static_cast<std::uint32_t>(result.planes.size());
  cluster_rest(thinned.points, options, rest, plane_count + 1, label);
  result.times.segments = lap();
  pcl::console::setVerbosityLevel(verbosity);

  result.has_planes = true;
  result.point_label.assign(cloud.size(), kNoSegment);
  result.point_plane.assign(cloud.size(), kNone);
  for (std::size_t i = 0; i < finite.size(); ++i) {
    const std::uint32_t found = label[thinned.of_finite[i]];
    result.point_label[finite[i]] = found;
    if (found != kNoSegment && found <= plane_count)
      result.point_plane[finite[i]] = static_cast<std::int32_t>(found) - 1;
  }
  result.times.labels = lap();
  result.segment_count = rank_labels(result.point_label);
  result.times.convert = lap();
  return result;
}

}  // namespace planescope
