// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "connected_voxel.hpp"

#include <vector>

#include "patches/range_warp.hpp"
#include "patches/voxel_grid.hpp"
#include "planescope/error.hpp"
#include "single_scan.hpp"
#include "union_find.hpp"

namespace planescope {
namespace {

// How well voxels hang together.
struct Cohesion {
  double degree = 0;        // mean number of occupied neighbours
  double connectivity = 0;  // the chance that a way leads from one voxel to another, at random
  double crumbs = 0;        // share of voxels in pieces of less than kCrumb
};

Cohesion measure_cohesion(const PointCloud& cloud, double voxel) {
  constexpr double kCrumb = 100;  // [voxel]
  const VoxelGrid grid = make_voxel_grid(cloud, voxel, false);
  UnionFind sets(grid.voxel_count());
  for (std::uint32_t v = 0; v < grid.voxel_count(); ++v) {
    for (std::size_t k = grid.neighbour_offsets[v]; k < grid.neighbour_offsets[v + 1]; ++k) {
      if (grid.neighbours[k] < v) sets.unite(v, grid.neighbours[k]);
    }
  }
  std::vector<double> sizes(grid.voxel_count(), 0);
  for (std::uint32_t v = 0; v < grid.voxel_count(); ++v) ++sizes[sets.find(v)];
  const auto all = double(grid.voxel_count());
  Cohesion cohesion{.degree = double(grid.neighbours.size()) / all};
  for (const double size : sizes) {
    cohesion.connectivity += size * size / (all * all);
    if (size < kCrumb) cohesion.crumbs += size / all;
  }
  return cohesion;
}

// Where points lie in rows, as a fused map's vertices do, voxels narrower than the rows are apart
// leave whole rows empty (a moire), and cut surfaces along the map's axes into tiles: a table top,
// say, while the oblique walls, where the points lie closer, hold. The tiles of voxels a little
// narrower than the rows are large, those of still narrower ones small: so rows are looked for in
// voxels of this share. Crumbs that wider voxels have too are noise.
bool cut_to_tiles(const PointCloud& cloud, double voxel, const Cohesion& wide) {
  constexpr double kNarrow = 0.85, kMostCrumbs = 0.01;
  return measure_cohesion(cloud, kNarrow * voxel).crumbs > kMostCrumbs + 2 * wide.crumbs;
}

// The smallest size at which voxels have neighbours enough and, in a map, hang together as voxels
// twice as wide do.
double find_size(const PointCloud& cloud, double smallest, bool map) {
  constexpr double kWantedDegree = 5, kWantedShare = 0.8, kLargest = 4;
  const double step = map ? 1.12 : 1.25;  // faces of maps are lost to coarse voxels
  const Cohesion wide = map ? measure_cohesion(cloud, 2 * smallest) : Cohesion{};
  const auto suits = [&](double voxel) {
    const Cohesion cohesion = measure_cohesion(cloud, voxel);
    if (cohesion.degree < kWantedDegree) return false;
    if (!map) return true;
    const bool whole = cohesion.connectivity >= kWantedShare * wide.connectivity;
    return whole && !cut_to_tiles(cloud, voxel, wide);
  };
  double size = smallest;
  while (size < kLargest * smallest && !suits(size)) size *= step;
  return size;
}

}  // namespace

double find_connected_voxel(const PointCloud& cloud, double smallest, double median_range) {
  if (cloud.organised()) return smallest;  // a picture's pixels are as dense along as across
  const bool map = median_range == 0;
  PointCloud warped;  // of a single scan: as voxels that grow with the range see it
  if (!map) {
    const RangeWarp warp(cloud, kScanRangeExponent,
                         cloud.sensor.value_or(-cloud.origin.cast<float>()));
    for (const Eigen::Vector3f& p : cloud.positions) warped.positions.push_back(warp.apply(p));
  }
  try {
    return find_size(map ? cloud : warped, smallest, map);
  } catch (const Error& error) {  // an outlier beyond any grid: make_patches() says so, not a
    if (error.kind() != Error::Kind::Computation) throw;  // measurement
    return smallest;
  }
}

}  // namespace planescope
