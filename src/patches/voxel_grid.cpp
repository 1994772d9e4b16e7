// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_grid.hpp"

#include <algorithm>
#include <sstream>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "patches/grid_bounds.hpp"
#include "patches/occupancy.hpp"
#include "patches/voxel_links.hpp"
#include "planescope/error.hpp"
#include "simd.hpp"

namespace planescope {
namespace {

using Range = tbb::blocked_range<std::size_t>;

// Bounds of a cloud that a grid can be laid over.
GridBounds checked_bounds(const PointCloud& cloud, double voxel_size) {
  const double longest = (double(1u << kAxisBits) - 16) * voxel_size;
  GridBounds bounds = find_grid_bounds(cloud, longest);
  if (!(bounds.extent() < longest)) {
    std::ostringstream message;
    message << "the cloud spans " << bounds.extent() << " m, more than " << (1u << kAxisBits)
            << " voxels of " << voxel_size << " m; remove outliers or choose a larger --voxel-size";
    throw Error(Error::Kind::Computation, message.str());
  }
  return bounds;
}

// Each voxel's sums run over its points in the cloud's order, whichever thread does it: every task
// reads all of point_voxel and adds up the voxels of its own range only. Sums are double: a million
// equal points stay exact.
void average_points(const PointCloud& cloud, VoxelGrid& grid, std::size_t voxel_count,
                    bool with_color) {
  grid.mean.resize(voxel_count);
  grid.point_count.assign(voxel_count, 0);
  if (with_color) grid.color.resize(voxel_count);
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t tasks = std::clamp<std::size_t>(threads, 1, 8);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    const std::size_t begin = voxel_count * task / tasks, end = voxel_count * (task + 1) / tasks;
    std::vector<Eigen::Vector3d> sums(end - begin, Eigen::Vector3d::Zero());
    std::vector<Eigen::Vector3f> colors(with_color ? end - begin : 0, Eigen::Vector3f::Zero());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::size_t voxel = grid.point_voxel[i];
      if (voxel < begin || voxel >= end) continue;
      sums[voxel - begin] += cloud.positions[i].cast<double>();
      ++grid.point_count[voxel];
      if (with_color) {
        const Rgb& c = cloud.colors[i];
        colors[voxel - begin] += Eigen::Vector3f(c.r, c.g, c.b);
      }
    }
    for (std::size_t voxel = begin; voxel < end; ++voxel) {
      grid.mean[voxel] = (sums[voxel - begin] / grid.point_count[voxel]).cast<float>();
      if (with_color) grid.color[voxel] = colors[voxel - begin] / float(grid.point_count[voxel]);
    }
  });
}

}  // namespace

VoxelGrid make_voxel_grid(const PointCloud& cloud, double voxel_size, bool with_color) {
  VoxelGrid grid;
  grid.size = static_cast<float>(voxel_size);
  const GridBounds bounds = checked_bounds(cloud, voxel_size);
  grid.lower = bounds.lower;
  grid.stray_points = bounds.strays;
  const VoxelBlocks blocks =
      find_occupied(cloud, bounds, static_cast<float>(1.0 / voxel_size), grid.point_voxel);
  average_points(cloud, grid, blocks.voxel_count, with_color && cloud.has_colors());
  link_voxels(blocks, grid);
  return grid;
}

}  // namespace planescope
