// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/moments.hpp"
#include "patches/voxel_grid.hpp"

namespace planescope {
namespace {

constexpr int kScales = 3;     // cells of 1, 2 and 4 times the smallest
constexpr int kRounds = 3;     // each takes most of the thickness that the window sees
constexpr int kSpreads = 2;    // of the moments to the 26 neighbours
constexpr float kFewest = 27;  // points, each counted once a path: a filled plane has 81 a point

// The plane through the surroundings of each voxel of a grid.
struct LocalPlanes {
  VoxelGrid grid;
  std::vector<Eigen::Vector3f> normal, point;
  std::vector<float> flatness;  // thickness / width, in [0, 1]: 0 is a plane
};

// The moments of each voxel and its neighbours, about the voxel's own mean.
std::vector<Moments> spread(const VoxelGrid& grid, const std::vector<Moments>& moments) {
  std::vector<Moments> result(moments.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, moments.size(), 1024), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
          Moments sum = moments[v];
          for (std::size_t k = grid.neighbour_offsets[v]; k < grid.neighbour_offsets[v + 1]; ++k) {
            const std::uint32_t n = grid.neighbours[k];
            sum.add_shifted(moments[n], grid.mean[n] - grid.mean[v]);
          }
          result[v] = sum;
        }
      });
  return result;
}

LocalPlanes fit_local_planes(const PointCloud& cloud, double cell) {
  LocalPlanes local;
  local.grid = make_voxel_grid(cloud, cell, false);
  const VoxelGrid& grid = local.grid;
  std::vector<Moments> moments(grid.voxel_count());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t v = grid.point_voxel[i];
    if (v != kNoVoxel) moments[v].add(cloud.positions[i] - grid.mean[v]);
  }
  for (int s = 0; s < kSpreads; ++s) moments = spread(grid, moments);
  local.normal.assign(moments.size(), Eigen::Vector3f::Zero());  // few points: nothing to move to
  local.point.resize(moments.size());
  local.flatness.assign(moments.size(), 1.0f);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, moments.size(), 1024),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v != range.end(); ++v) {
                        local.point[v] = grid.mean[v] + moments[v].first / moments[v].count;
                        if (moments[v].count < kFewest) continue;
                        const PrincipalPlane plane = principal_plane(moments[v]);
                        local.normal[v] = plane.normal;
                        local.flatness[v] = std::sqrt(plane.curvature);
                      }
                    });
  return local;
}

// The smallest window that is nearly as flat as the flattest.
const LocalPlanes& choose_scale(const std::array<LocalPlanes, kScales>& scales, std::size_t i) {
  constexpr float kSlack = 1.3f, kFlat = 0.03f;
  float least = 1;
  for (const LocalPlanes& s : scales) least = std::min(least, s.flatness[s.grid.point_voxel[i]]);
  const auto chosen = std::ranges::find_if(scales, [&](const LocalPlanes& s) {
    return s.flatness[s.grid.point_voxel[i]] <= kSlack * least + kFlat;
  });
  return *chosen;  // the flattest itself passes
}

void project(PointCloud& cloud, double cell) {
  std::array<LocalPlanes, kScales> scales;
  tbb::parallel_for(0, kScales, [&](int s) {
    scales[static_cast<std::size_t>(s)] = fit_local_planes(cloud, cell * (1 << s));
  });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), 16384),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        if (scales[0].grid.point_voxel[i] == kNoVoxel) continue;
                        const LocalPlanes& local = choose_scale(scales, i);
                        const std::uint32_t v = local.grid.point_voxel[i];
                        Eigen::Vector3f& p = cloud.positions[i];
                        p -= local.normal[v] * local.normal[v].dot(p - local.point[v]);
                      }
                    });
}

}  // namespace

PointCloud smooth_points(const PointCloud& cloud, double cell) {
  PointCloud smooth;
  smooth.positions = cloud.positions;
  smooth.colors = cloud.colors;
  smooth.normals = cloud.normals;
  smooth.radii = cloud.radii;
  smooth.origin = cloud.origin;
  smooth.width = cloud.width;
  smooth.height = cloud.height;
  smooth.sensor = cloud.sensor;
  for (int round = 0; round < kRounds; ++round) project(smooth, cell);
  return smooth;
}

}  // namespace planescope
