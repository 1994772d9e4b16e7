// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "patches/creases.hpp"
#include "patches/growth.hpp"
#include "patches/moments.hpp"
#include "patches/orientation.hpp"
#include "patches/range_warp.hpp"
#include "patches/voxel_grid.hpp"
#include "patches/voxel_normals.hpp"
#include "planescope/patches.hpp"

namespace planescope {
namespace {

// The voxels of each patch in compressed rows, ascending.
struct Members {
  std::vector<std::uint32_t> offsets, voxels;
  std::size_t patch_count() const { return offsets.size() - 1; }
};

// Makes labels contiguous (a seed may lose all its voxels to others), and lists each patch's
// voxels.
Members renumber(std::vector<std::int32_t>& label, std::size_t seed_count) {
  std::vector<std::uint32_t> count(seed_count, 0);
  for (const std::int32_t l : label) {
    if (l != kNone) ++count[static_cast<std::size_t>(l)];
  }
  std::vector<std::int32_t> renamed(seed_count, kNone);
  Members members;
  members.offsets.push_back(0);
  for (std::size_t s = 0; s < seed_count; ++s) {
    if (count[s] == 0) continue;
    renamed[s] = static_cast<std::int32_t>(members.offsets.size() - 1);
    members.offsets.push_back(members.offsets.back() + count[s]);
  }
  members.voxels.resize(members.offsets.back());
  std::vector<std::uint32_t> next(members.offsets.begin(), members.offsets.end() - 1);
  for (std::size_t v = 0; v < label.size(); ++v) {
    if (label[v] == kNone) continue;
    label[v] = renamed[static_cast<std::size_t>(label[v])];
    members.voxels[next[static_cast<std::size_t>(label[v])]++] = static_cast<std::uint32_t>(v);
  }
  return members;
}

// The voxels where they lie in the world, and how the grid was warped to find them.
struct Surface {
  const VoxelGrid& grid;
  const RangeWarp& warp;
  const std::vector<Eigen::Vector3f>& mean;
  const std::vector<Eigen::Vector3f>& normals;
};

Patch describe_patch(const Surface& surface, const std::uint32_t* begin, const std::uint32_t* end) {
  const VoxelGrid& grid = surface.grid;
  const std::vector<Eigen::Vector3f>& normals = surface.normals;
  const Eigen::Vector3f reference = surface.mean[*begin];
  Moments moments;
  Patch patch;
  Eigen::Vector3f normal_sum = Eigen::Vector3f::Zero();
  for (const std::uint32_t* v = begin; v != end; ++v) {
    moments.add(surface.mean[*v] - reference);
    patch.point_count += grid.point_count[*v];
    normal_sum +=
        normals[*v].dot(normals[*begin]) < 0 ? Eigen::Vector3f(-normals[*v]) : normals[*v];
  }
  patch.voxel_count = static_cast<std::uint32_t>(end - begin);
  patch.centroid = reference + moments.first / moments.count;
  const PrincipalPlane plane = principal_plane(moments);
  // Principal components of a handful of voxels say nothing; their own normals saw two rings around
  // them.
  constexpr std::uint32_t kEnoughVoxels = 6;
  const bool enough = patch.voxel_count >= kEnoughVoxels;
  patch.normal = enough || normal_sum.squaredNorm() == 0 ? plane.normal : normal_sum.normalized();
  patch.curvature = plane.curvature;
  patch.area = surface.warp.area(patch.centroid, patch.normal, float(patch.voxel_count), grid.size);
  patch.scale = surface.warp.scale(patch.centroid);
  return patch;
}

std::vector<Patch> describe_patches(const Surface& surface, const Members& members) {
  std::vector<Patch> patches(members.patch_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, patches.size(), 64), [&](const auto& range) {
    for (std::size_t p = range.begin(); p != range.end(); ++p) {
      patches[p] = describe_patch(surface, &members.voxels[members.offsets[p]],
                                  members.voxels.data() + members.offsets[p + 1]);
    }
  });
  return patches;
}

// Counts of a patch's neighbours, sparse: a dense array a thread, cleared through the list of what
// was touched.
class BorderCounter {
 public:
  void reserve(std::size_t patches) { count_.resize(patches, 0); }

  // Adds a voxel's neighbours of patches above `patch`: not kNone, nor what was counted from there.
  // Which they are is decided without branches: they would be taken at random.
  void add(const VoxelGrid& grid, const std::vector<std::int32_t>& label, std::uint32_t voxel,
           std::int32_t patch) {
    std::array<std::int32_t, 27> above;
    std::size_t size = 0;
    for (std::size_t k = grid.neighbour_offsets[voxel];
         k < grid.neighbour_offsets[voxel + std::size_t{1}]; ++k) {
      above[size] = label[grid.neighbours[k]];
      size += above[size] > patch ? 1 : 0;
    }
    for (std::size_t i = 0; i < size; ++i) {
      const auto other = static_cast<std::uint32_t>(above[i]);
      if (count_[other]++ == 0) touched_.push_back(other);
    }
  }

  // The patch's pairs, ascending; the counter is then as new.
  void move_to(std::uint32_t patch, std::vector<Adjacency>& pairs) {
    std::sort(touched_.begin(), touched_.end());
    for (const std::uint32_t other : touched_) {
      pairs.push_back({patch, other, std::exchange(count_[other], 0)});
    }
    touched_.clear();
  }

 private:
  std::vector<std::uint32_t> count_, touched_;
};

std::vector<Adjacency> find_adjacency(const VoxelGrid& grid, const std::vector<std::int32_t>& label,
                                      const Members& members) {
  std::vector<std::vector<Adjacency>> rows(members.patch_count());
  tbb::enumerable_thread_specific<BorderCounter> counters;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows.size(), 64), [&](const auto& range) {
    BorderCounter& counter = counters.local();
    counter.reserve(rows.size());
    for (std::size_t p = range.begin(); p != range.end(); ++p) {
      for (std::size_t m = members.offsets[p]; m < members.offsets[p + 1]; ++m)
        counter.add(grid, label, members.voxels[m], static_cast<std::int32_t>(p));
      counter.move_to(static_cast<std::uint32_t>(p), rows[p]);
    }
  });
  std::vector<Adjacency> adjacency;
  for (const auto& row : rows) adjacency.insert(adjacency.end(), row.begin(), row.end());
  return adjacency;
}

// From voxels to points.
std::vector<std::int32_t> label_points(const std::vector<std::uint32_t>& point_voxel,
                                       const std::vector<std::int32_t>& label) {
  std::vector<std::int32_t> point_patch(point_voxel.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, point_voxel.size(), 65536),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        point_patch[i] = point_voxel[i] == kNoVoxel ? kNone : label[point_voxel[i]];
                      }
                    });
  return point_patch;
}

// What a point's given normal counts: a surfel's by the area of its disc, in units of a voxel's.
// Any finer use of surfels' own normals lost to those of two rings of voxels (WO -0.05 to 0 on
// fused maps).
float vote_weight(const PointCloud& cloud, std::size_t i, float voxel_size) {
  if (!cloud.has_radii() || !std::isfinite(cloud.radii[i])) return 1;
  const float r = cloud.radii[i] / voxel_size;
  return r * r;
}

// Sums of red, green and blue in 32 bits each, added in two steps.
struct ColorSums {
  static constexpr std::size_t kMostPoints = std::size_t{1} << 24;  // what 32 bits hold
  std::uint64_t red_green = 0, blue = 0;

  void add(const Rgb& c) {
    red_green += std::uint64_t{c.g} << 32 | c.r;
    blue += c.b;
  }
  Eigen::Vector3d sums() const {
    return {double(red_green & 0xffffffff), double(red_green >> 32), double(blue)};
  }
};

// What the points themselves say of their patch: mean colour, and the sum of their given normals.
// The sums of whole numbers are the same in any order; those of normals run over fixed parts of the
// cloud, one after the other.
std::vector<Eigen::Vector3f> gather_point_votes(const PointCloud& cloud, bool with_normals,
                                                PatchGraph& graph) {
  struct Part {
    std::vector<ColorSums> colors;
    std::vector<Eigen::Vector3f> votes;
  };
  std::vector<Part> parts(std::max<std::size_t>(8, cloud.size() / ColorSums::kMostPoints + 1));
  const std::size_t patches = graph.patches.size();
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
    Part& part = parts[k];
    part.colors.resize(cloud.has_colors() ? patches : 0);
    part.votes.resize(with_normals ? patches : 0, Eigen::Vector3f::Zero());
    const std::size_t end = cloud.size() * (k + 1) / parts.size();
    for (std::size_t i = cloud.size() * k / parts.size(); i < end; ++i) {
      if (graph.point_patch[i] == kNone) continue;
      const auto p = static_cast<std::size_t>(graph.point_patch[i]);
      if (cloud.has_colors()) part.colors[p].add(cloud.colors[i]);
      if (with_normals && is_finite(cloud.normals[i]))
        part.votes[p] += vote_weight(cloud, i, graph.voxel_size) * cloud.normals[i];
    }
  });
  std::vector<Eigen::Vector3f> votes(with_normals ? patches : 0, Eigen::Vector3f::Zero());
  for (std::size_t p = 0; p < patches; ++p) {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (const Part& part : parts) {
      if (with_normals) votes[p] += part.votes[p];
      if (!part.colors.empty()) color += part.colors[p].sums();
    }
    graph.patches[p].color = (color / graph.patches[p].point_count).cast<float>();
  }
  return votes;
}

// Where a single scan was taken from; nothing where the cloud is a map.
std::optional<Eigen::Vector3f> find_sensor(const PointCloud& cloud, const PatchOptions& options) {
  if (cloud.sensor || options.range_exponent == 0) return cloud.sensor;
  return Eigen::Vector3f((-cloud.origin).cast<float>());
}

PointCloud warp_points(const PointCloud& cloud, const RangeWarp& warp, bool with_color) {
  PointCloud warped;
  if (with_color) warped.colors = cloud.colors;
  warped.positions.resize(cloud.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), 16384),
                    [&](const auto& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        warped.positions[i] = warp.apply(cloud.positions[i]);
                      }
                    });
  return warped;
}

}  // namespace

PatchGraph make_patches(const PointCloud& cloud, const PatchOptions& options,
                        const Progress& progress) {
  const auto report = [&](double fraction) {
    if (progress) progress("patches", fraction);
  };
  report(0);
  const std::optional<Eigen::Vector3f> sensor = find_sensor(cloud, options);
  const bool with_color = options.weight_color > 0;
  const bool warped = options.range_exponent > 0;
  const RangeWarp warp = warped ? RangeWarp(cloud, options.range_exponent, *sensor) : RangeWarp();
  const VoxelGrid grid =
      warped ? make_voxel_grid(warp_points(cloud, warp, with_color), options.voxel_size, with_color)
             : make_voxel_grid(cloud, options.voxel_size, with_color);
  std::vector<Eigen::Vector3f> unwarped;  // where the voxels lie in the world
  if (warped) {
    unwarped = grid.mean;
    for (Eigen::Vector3f& mean : unwarped) mean = warp.invert(mean);
  }
  const std::vector<Eigen::Vector3f>& mean = warped ? unwarped : grid.mean;
  report(0.3);
  const std::vector<Eigen::Vector3f> normals = estimate_voxel_normals(grid, mean);
  report(0.5);
  const std::vector<std::uint32_t> seeds = choose_seeds(grid, options.patch_size);
  std::vector<std::int32_t> label = grow_patches(grid, normals, seeds, options);
  report(0.8);
  const Members members = renumber(label, seeds.size());
  PatchGraph graph;
  graph.voxel_size = static_cast<float>(options.voxel_size);
  graph.patch_size = static_cast<float>(options.patch_size);
  graph.stray_points = grid.stray_points;
  graph.patches = describe_patches({grid, warp, mean, normals}, members);
  graph.adjacency = find_adjacency(grid, label, members);
  graph.point_patch = label_points(grid.point_voxel, label);
  cut_at_creases(cloud, graph);
  const std::vector<Eigen::Vector3f> votes =
      gather_point_votes(cloud, cloud.has_normals() && !sensor, graph);
  if (sensor) {
    orient_towards(graph.patches, *sensor);
  } else if (cloud.has_normals()) {
    orient_by_votes(graph.patches, votes);
  } else {
    orient_consistently(graph);
  }
  report(1);
  return graph;
}

}  // namespace planescope
