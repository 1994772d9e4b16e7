// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/growth.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

namespace planescope {
namespace {

// What distances to a patch are measured to: the means of its voxels.
struct Target {
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
};

// The sums behind a Target, kept up to date from sweep to sweep.
struct Sums {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d color = Eigen::Vector3d::Zero();
  Eigen::Vector3f reference;  // the seed's normal: gives the voxels' normals their sign
  std::uint32_t count = 0;
  bool touched = false;  // in this sweep
};

class Growth {
 public:
  Growth(const VoxelGrid& grid, const std::vector<Eigen::Vector3f>& normals,
         const std::vector<std::uint32_t>& seeds, const PatchOptions& options)
      : grid_(grid),
        normals_(normals),
        spatial_(static_cast<float>(options.weight_spatial / options.patch_size)),
        normal_(static_cast<float>(options.weight_normal)),
        color_(grid.color.empty() ? 0.0f : static_cast<float>(options.weight_color / 255)),
        targets_(seeds.size()),
        sums_(seeds.size()),
        label_(grid.voxel_count(), kNone),
        distance_(grid.voxel_count(), std::numeric_limits<float>::infinity()),
        frontier_((grid.voxel_count() + 7) / 8 * 8, 0),
        chunks_((grid.voxel_count() + kChunk - 1) / kChunk) {
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      sums_[s].reference = normals[seeds[s]];
      chunks_[seeds[s] / kChunk].claims.push_back(
          {seeds[s], static_cast<std::int32_t>(s), kNone, 0.0f});
    }
  }

  std::vector<std::int32_t> run(int sweeps) {
    for (int sweep = 0; apply(sweep >= sweeps); ++sweep) propose(sweep >= sweeps);
    return std::move(label_);
  }

 private:
  static constexpr std::size_t kChunk = 1024;  // voxels a task
  static constexpr std::size_t kAhead = 10;    // voxels between fetching a row and reading it

  // A voxel's move from one patch to another.
  struct Claim {
    std::uint32_t voxel;
    std::int32_t label, old;
    float distance;
  };

  // The claims of a task's voxels, ascending; tasks share no cache line.
  struct alignas(64) Chunk {
    std::vector<Claim> claims;
  };

  template <typename Body>
  void for_each_chunk(const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks_.size()), [&](const auto& range) {
      for (std::size_t c = range.begin(); c != range.end(); ++c) body(c);
    });
  }

  float distance(std::uint32_t voxel, const Target& patch) const {
    const float angle = 1 - std::abs(normals_[voxel].dot(patch.normal));
    float d = spatial_ * (grid_.mean[voxel] - patch.centroid).norm() + normal_ * angle;
    if (color_ > 0) d += color_ * (grid_.color[voxel] - patch.color).norm();
    return d;
  }

  // Which patches to ask is decided without branches: they would be taken at random.
  Claim best_claim(std::uint32_t voxel) const {
    const std::int32_t own = label_[voxel];
    std::array<std::int32_t, 27> asked;
    std::size_t count = 0;
    std::int32_t previous = own;  // neighbours mostly share a label with the one before
    for (std::size_t k = grid_.neighbour_offsets[voxel];
         k < grid_.neighbour_offsets[voxel + std::size_t{1}]; ++k) {
      const std::int32_t label = label_[grid_.neighbours[k]];
      asked[count] = label;
      count += ((label != previous) & (label != kNone)) ? 1 : 0;
      previous = label;
    }
    Claim best{voxel, own, own, distance_[voxel]};
    for (std::size_t i = 0; i < count; ++i) {
      if (asked[i] == best.label) continue;
      const float d = distance(voxel, targets_[static_cast<std::size_t>(asked[i])]);
      if (d < best.distance || (d == best.distance && asked[i] < best.label)) {
        best.label = asked[i];
        best.distance = d;
      }
    }
    return best;
  }

  // The claims of the frontier's voxels. Reads labels of the last sweep only, so that the order of
  // evaluation does not matter.
  void propose(bool free_only) {
    for_each_chunk([&](std::size_t chunk) {
      std::array<std::uint32_t, kChunk> voxels;
      const std::size_t count = take_marked(chunk, free_only, voxels.data());
      std::vector<Claim>& claims = chunks_[chunk].claims;
      for (std::size_t i = 0; i < count; ++i) {
        prefetch_row(voxels[std::min(i + kAhead, count - 1)]);
        const Claim claim = best_claim(voxels[i]);
        if (claim.label != claim.old) claims.push_back(claim);
      }
    });
  }

  // The voxels of a chunk that are in the frontier, which they leave. \returns how many.
  std::size_t take_marked(std::size_t chunk, bool free_only, std::uint32_t* voxels) {
    std::size_t count = 0;
    const std::size_t end = std::min(label_.size(), (chunk + 1) * kChunk);
    for (std::size_t v = chunk * kChunk; v < end; v += 8) {
      std::uint64_t marks;  // of eight voxels
      std::memcpy(&marks, &frontier_[v], sizeof marks);
      if (marks == 0) continue;
      std::memset(&frontier_[v], 0, sizeof marks);
      for (; marks != 0; marks &= marks - 1) {
        const std::size_t voxel = v + static_cast<std::size_t>(std::countr_zero(marks)) / 8;
        voxels[count] = static_cast<std::uint32_t>(voxel);
        count += !free_only || label_[voxel] == kNone ? 1 : 0;
      }
    }
    return count;
  }

  // A frontier leaves gaps that the processor does not foresee.
  void prefetch_row(std::uint32_t voxel) const {
    __builtin_prefetch(grid_.neighbours.data() + grid_.neighbour_offsets[voxel]);
    __builtin_prefetch(&normals_[voxel]);
    __builtin_prefetch(&grid_.mean[voxel]);
  }

  // Makes the claims good: labels, then the next frontier and, beside it, the patches' means.
  // \returns whether there were any.
  bool apply(bool free_only) {
    for_each_chunk([&](std::size_t chunk) {
      for (const Claim& claim : chunks_[chunk].claims) {
        label_[claim.voxel] = claim.label;
        distance_[claim.voxel] = claim.distance;
      }
    });
    tbb::parallel_invoke([&] { mark_frontier(free_only); }, [&] { update_patches(); });
    bool any = false;
    for (Chunk& chunk : chunks_) {
      any |= !chunk.claims.empty();
      chunk.claims.clear();
    }
    return any;
  }

  // The voxels next to one that changed. Two tasks may mark the same one.
  void mark_frontier(bool free_only) {
    // Copies: a store of a byte may change any member, as far as the compiler knows.
    const std::uint32_t *offsets = grid_.neighbour_offsets.data(),
                        *neighbours = grid_.neighbours.data();
    const std::int32_t* labels = label_.data();
    std::uint8_t* marks = frontier_.data();
    for_each_chunk([&, offsets, neighbours, labels, marks](std::size_t chunk) {
      std::uint8_t nobody = 0;
      const std::vector<Claim>& claims = chunks_[chunk].claims;
      for (std::size_t i = 0; i < claims.size(); ++i) {
        const Claim& claim = claims[i];
        __builtin_prefetch(neighbours +
                           offsets[claims[std::min(i + kAhead, claims.size() - 1)].voxel]);
        const std::int32_t label = claim.label;
        const std::uint32_t* n = neighbours + offsets[claim.voxel];
        const std::uint32_t* end = neighbours + offsets[claim.voxel + std::size_t{1}];
        for (; n != end; ++n) {
          const bool mark = (labels[*n] != label) & (!free_only | (labels[*n] == kNone));
          const std::atomic_ref<std::uint8_t> target(mark ? marks[*n] : nobody);
          target.store(1, std::memory_order_relaxed);
        }
      }
    });
  }

  // Every task goes through all claims in their order and accounts for its own patches only: sums
  // run in the same order whatever the number of tasks.
  void update_patches() {
    constexpr std::size_t kRun = 16;  // neighbouring patches of one task: no shared cache lines
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t tasks = std::clamp<std::size_t>(threads, 1, 8);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
      std::vector<std::size_t> touched;
      const auto add = [&](std::uint32_t voxel, std::int32_t label, double sign) {
        const auto p = static_cast<std::size_t>(label);
        if (label == kNone || p / kRun % tasks != task) return;
        account(voxel, sums_[p], sign);
        if (!std::exchange(sums_[p].touched, true)) touched.push_back(p);
      };
      for (const Chunk& chunk : chunks_) {
        for (const Claim& claim : chunk.claims) {
          add(claim.voxel, claim.old, -1);
          add(claim.voxel, claim.label, 1);
        }
      }
      for (const std::size_t p : touched) refresh(sums_[p], targets_[p]);
    });
  }

  void account(std::uint32_t voxel, Sums& sums, double sign) const {
    const double side = normals_[voxel].dot(sums.reference) < 0 ? -sign : sign;
    sums.centroid += sign * grid_.mean[voxel].cast<double>();
    sums.normal += side * normals_[voxel].cast<double>();
    if (color_ > 0) sums.color += sign * grid_.color[voxel].cast<double>();
    sums.count = sign > 0 ? sums.count + 1 : sums.count - 1;
  }

  static void refresh(Sums& sums, Target& target) {
    sums.touched = false;
    if (sums.count == 0) return;
    target.centroid = (sums.centroid / sums.count).cast<float>();
    target.normal = sums.normal.normalized().cast<float>();
    target.color = (sums.color / sums.count).cast<float>();
  }

  const VoxelGrid& grid_;
  const std::vector<Eigen::Vector3f>& normals_;
  const float spatial_, normal_, color_;
  std::vector<Target> targets_;
  std::vector<Sums> sums_;
  std::vector<std::int32_t> label_;
  std::vector<float> distance_;
  std::vector<std::uint8_t> frontier_;  // 1: a neighbour changed, so the voxel may too
  std::vector<Chunk> chunks_;
};

}  // namespace

std::vector<std::int32_t> grow_patches(const VoxelGrid& grid,
                                       const std::vector<Eigen::Vector3f>& normals,
                                       const std::vector<std::uint32_t>& seeds,
                                       const PatchOptions& options) {
  const int sweeps = static_cast<int>(std::ceil(1.8 * options.patch_size / options.voxel_size));
  return Growth(grid, normals, seeds, options).run(sweeps);
}

}  // namespace planescope
