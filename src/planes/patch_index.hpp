// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "planes/bits.hpp"
#include "planescope/patches.hpp"
#include "planescope/planes.hpp"

/// \file Patches laid out for the one question that hypotheses ask a hundred thousand times: which
/// patches are inliers of this plane?
namespace planescope {

/// What makes a patch an inlier: r(c, p) < half_width * scale of the patch, |n . n_p| >= gate, and,
/// for a local fit, a centroid within `radius` of `center`.
struct InlierTest {
  Plane plane;
  float half_width = 0;  ///< [m]
  float gate = 0;        ///< [1]
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = std::numeric_limits<float>::infinity();  ///< [m]
};

/// Centroids, normals and weights as arrays in Morton order. Blocks of 64 consecutive patches lie
/// close together, so that the box of a block tells that most blocks are far from a plane, and the
/// cost of a question follows the area that the plane crosses rather than the number of patches.
class PatchIndex {
 public:
  explicit PatchIndex(const std::vector<Patch>& patches);

  /// A sample of this index, spread evenly over the surface: one patch of each of `count` equal
  /// runs of the Morton order. All of it if it has no more.
  PatchIndex sample(std::size_t count, std::uint64_t seed) const;

  std::size_t size() const { return patch_.size(); }
  std::size_t words() const { return blocks_.size(); }

  /// The patch id at a position of the Morton order; positions are what Bits hold.
  std::uint32_t patch(std::size_t position) const { return patch_[position]; }
  Eigen::Vector3f centroid(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
  Eigen::Vector3f normal(std::size_t i) const { return {nx_[i], ny_[i], nz_[i]}; }
  float area(std::size_t i) const { return area_[i]; }
  float scale(std::size_t i) const { return scale_[i]; }
  float curvature(std::size_t i) const { return curvature_[i]; }

  /// 64 consecutive patches, word by word of Bits, as columns; past the end of the index they hold
  /// zeros and normals that are no numbers.
  struct Columns {
    const float *x, *y, *z, *nx, *ny, *nz, *area, *scale;
    Eigen::Vector3f center;  ///< [m] of the box of their centroids
  };
  Columns columns(std::size_t word) const {
    const std::size_t i = word * 64;
    return {&x_[i],    &y_[i],     &z_[i],
            &nx_[i],   &ny_[i],    &nz_[i],
            &area_[i], &scale_[i], blocks_[word].center};
  }

  /// Positions of the inliers. A patch with a non-finite centroid or normal is never one.
  Bits inliers(const InlierTest& test) const;

 private:
  struct Block {
    Eigen::Vector3f center, half;  ///< [m] box of its centroids
    float scale;                   ///< largest of its patches' scales
  };

  PatchIndex() = default;
  void add(std::uint32_t id, const Patch& patch);
  void finish();  ///< pads to whole blocks and measures their boxes
  bool may_hold(const Block& block, const InlierTest& test) const;
  template <bool kLocal>
  std::uint64_t test_block(const Columns& block, const InlierTest& test) const;

  std::vector<float> x_, y_, z_, nx_, ny_, nz_;
  std::vector<float> area_, curvature_, scale_;
  std::vector<std::uint32_t> patch_;
  std::vector<Block> blocks_;
};

}  // namespace planescope
