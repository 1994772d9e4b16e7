// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_normals.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/moments.hpp"

namespace planescope {
namespace {

template <typename Body>
void for_each_voxel(const VoxelGrid& grid, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.voxel_count(), 2048),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t v = range.begin(); v != range.end(); ++v) body(v);
                    });
}

}  // namespace

std::vector<Eigen::Vector3f> estimate_voxel_normals(const VoxelGrid& grid,
                                                    const std::vector<Eigen::Vector3f>& mean) {
  std::vector<Moments> ring(grid.voxel_count());  // S(m), each about its voxel's own mean
  for_each_voxel(grid, [&](std::size_t v) {
    Moments sum;
    sum.count = 1;  // the voxel itself, at its own reference
    for (std::size_t k = grid.neighbour_offsets[v]; k < grid.neighbour_offsets[v + 1]; ++k) {
      sum.add(mean[grid.neighbours[k]] - mean[v]);
    }
    ring[v] = sum;
  });
  std::vector<Eigen::Vector3f> normals(grid.voxel_count());
  for_each_voxel(grid, [&](std::size_t v) {
    Moments sum = ring[v];  // S(m) once more, as its own part of S(S(m))
    sum.add_shifted(ring[v], Eigen::Vector3f::Zero());
    sum.count += 1;  // m
    for (std::size_t k = grid.neighbour_offsets[v]; k < grid.neighbour_offsets[v + 1]; ++k) {
      const std::uint32_t n = grid.neighbours[k];
      sum.add_shifted(ring[n], mean[n] - mean[v]);
    }
    normals[v] = principal_plane(sum).normal;
  });
  return normals;
}

}  // namespace planescope
