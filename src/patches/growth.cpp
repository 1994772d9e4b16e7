// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/voxel_blocks.hpp"

namespace planescope {
namespace {

// A patch as growth sees it: the means of its voxels, kept up to date from sweep to sweep.
struct Growing {
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  // what distances are measured to ...
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  Eigen::Vector3d centroid_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d color_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3f reference;  // the seed's normal: gives the voxels' normals their sign
  std::uint32_t count = 0;
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
        patches_(seeds.size()),
        label_(grid.voxel_count(), kNone),
        distance_(grid.voxel_count(), std::numeric_limits<float>::infinity()),
        marked_(grid.voxel_count(), 0) {
    for (std::size_t s = 0; s < seeds.size(); ++s) {
      patches_[s].reference = normals[seeds[s]];
      changed_.push_back({seeds[s], static_cast<std::int32_t>(s), 0.0f});
    }
    apply();
  }

  std::vector<std::int32_t> run(int sweeps) {
    for (int sweep = 0; !frontier_.empty(); ++sweep) {
      const bool free_only = sweep >= sweeps;
      propose(free_only);
      apply();
    }
    return std::move(label_);
  }

 private:
  struct Claim {
    std::uint32_t voxel;
    std::int32_t label;
    float distance;
  };

  float distance(std::uint32_t voxel, const Growing& patch) const {
    const float angle = 1 - std::abs(normals_[voxel].dot(patch.normal));
    float d = spatial_ * (grid_.mean[voxel] - patch.centroid).norm() + normal_ * angle;
    if (color_ > 0) d += color_ * (grid_.color[voxel] - patch.color).norm();
    return d;
  }

  Claim best_claim(std::uint32_t voxel, bool free_only) const {
    Claim best{voxel, label_[voxel], distance_[voxel]};
    if (free_only && best.label != kNone) return best;
    std::int32_t last = kNone;  // neighbours mostly share a label
    for (std::size_t k = grid_.neighbour_offsets[voxel]; k < grid_.neighbour_offsets[voxel + 1];
         ++k) {
      const std::int32_t label = label_[grid_.neighbours[k]];
      if (label == kNone || label == last || label == best.label) continue;
      last = label;
      const float d = distance(voxel, patches_[static_cast<std::size_t>(label)]);
      if (d < best.distance || (d == best.distance && label < best.label)) best = {voxel, label, d};
    }
    return best;
  }

  // Reads labels of the last sweep only, so that the order of evaluation does not matter.
  void propose(bool free_only) {
    claims_.resize(frontier_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, frontier_.size(), 1024),
                      [&](const auto& range) {
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          claims_[i] = best_claim(frontier_[i], free_only);
                        }
                      });
    changed_.clear();
    for (const Claim& claim : claims_) {
      marked_[claim.voxel] = 0;
      if (claim.label != label_[claim.voxel]) changed_.push_back(claim);
    }
  }

  // Moves the changed voxels in the frontier's order, updates the patches' means, and marks the
  // next frontier.
  void apply() {
    for (const Claim& claim : changed_) {
      std::int32_t& label = label_[claim.voxel];
      if (label != kNone) account(claim.voxel, label, -1);
      account(claim.voxel, claim.label, 1);
      label = claim.label;
      distance_[claim.voxel] = claim.distance;
    }
    for (const std::int32_t p : touched_) refresh(patches_[static_cast<std::size_t>(p)]);
    touched_.clear();
    frontier_.clear();
    for (const Claim& claim : changed_) {
      for (std::size_t k = grid_.neighbour_offsets[claim.voxel];
           k < grid_.neighbour_offsets[claim.voxel + std::size_t{1}]; ++k) {
        const std::uint32_t n = grid_.neighbours[k];
        if (marked_[n] != 0 || label_[n] == claim.label) continue;
        marked_[n] = 1;
        frontier_.push_back(n);
      }
    }
  }

  void account(std::uint32_t voxel, std::int32_t label, double sign) {
    Growing& patch = patches_[static_cast<std::size_t>(label)];
    const double side = normals_[voxel].dot(patch.reference) < 0 ? -sign : sign;
    patch.centroid_sum += sign * grid_.mean[voxel].cast<double>();
    patch.normal_sum += side * normals_[voxel].cast<double>();
    if (color_ > 0) patch.color_sum += sign * grid_.color[voxel].cast<double>();
    patch.count = sign > 0 ? patch.count + 1 : patch.count - 1;
    touched_.push_back(label);
  }

  static void refresh(Growing& patch) {
    if (patch.count == 0) return;
    patch.centroid = (patch.centroid_sum / patch.count).cast<float>();
    patch.normal = patch.normal_sum.normalized().cast<float>();
    patch.color = (patch.color_sum / patch.count).cast<float>();
  }

  const VoxelGrid& grid_;
  const std::vector<Eigen::Vector3f>& normals_;
  const float spatial_, normal_, color_;
  std::vector<Growing> patches_;
  std::vector<std::int32_t> label_;
  std::vector<float> distance_;
  std::vector<std::uint8_t> marked_;     // is in the frontier
  std::vector<std::uint32_t> frontier_;  // voxels next to one that changed
  std::vector<Claim> claims_, changed_;
  std::vector<std::int32_t> touched_;
};

// A cell of the seed grid.
struct SeedCell {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::uint32_t count = 0;
  std::uint32_t voxel = kNoVoxel;
  float distance = std::numeric_limits<float>::infinity();
};

}  // namespace

std::vector<std::uint32_t> choose_seeds(const VoxelGrid& grid, double patch_size) {
  const auto inverse = static_cast<float>(1.0 / patch_size);
  const auto key_of = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f scaled = (p - grid.lower) * inverse;
    return static_cast<std::uint64_t>(scaled.z()) << 42 |
           static_cast<std::uint64_t>(scaled.y()) << 21 | static_cast<std::uint64_t>(scaled.x());
  };
  BlockMap map(grid.voxel_count() / 16 + 16);
  std::vector<SeedCell> cells;
  std::vector<std::uint32_t> cell_of(grid.voxel_count());
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    cell_of[v] = map.insert(key_of(grid.mean[v]));
    if (cell_of[v] == cells.size()) cells.emplace_back();
    cells[cell_of[v]].sum += grid.mean[v].cast<double>();
    ++cells[cell_of[v]].count;
  }
  for (std::size_t v = 0; v < grid.voxel_count(); ++v) {
    SeedCell& cell = cells[cell_of[v]];
    const Eigen::Vector3f mean = (cell.sum / cell.count).cast<float>();
    const float d = (grid.mean[v] - mean).squaredNorm();
    if (d < cell.distance) {
      cell.distance = d;
      cell.voxel = static_cast<std::uint32_t>(v);
    }
  }
  const double radius = 0.5 * patch_size / grid.size;  // [voxels]
  const double enough = 0.05 * radius * radius * 3.14159265358979;
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return map.keys()[a] < map.keys()[b]; });
  std::vector<std::uint32_t> seeds;
  for (const std::uint32_t c : order) {
    if (cells[c].count >= enough) seeds.push_back(cells[c].voxel);
  }
  return seeds;
}

std::vector<std::int32_t> grow_patches(const VoxelGrid& grid,
                                       const std::vector<Eigen::Vector3f>& normals,
                                       const std::vector<std::uint32_t>& seeds,
                                       const PatchOptions& options) {
  const int sweeps = static_cast<int>(std::ceil(1.8 * options.patch_size / options.voxel_size));
  return Growth(grid, normals, seeds, options).run(sweeps);
}

}  // namespace planescope
