// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/patch_index.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <tbb/parallel_sort.h>
#include <Eigen/Geometry>

#include "planes/random.hpp"
#include "simd.hpp"

namespace planescope {
namespace {

constexpr std::size_t kBlock = 64;

/// Spreads the lowest 10 bits to every third bit.
std::uint32_t spread(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000ffu;
  v = (v | (v << 8)) & 0x0300f00fu;
  v = (v | (v << 4)) & 0x030c30c3u;
  return (v | (v << 2)) & 0x09249249u;
}

Eigen::AlignedBox3f bounds_of(const std::vector<Patch>& patches) {
  Eigen::AlignedBox3f box;
  for (const Patch& patch : patches) {
    if (is_finite(patch.centroid)) box.extend(patch.centroid);
  }
  return box;
}

/// Patch ids along the Morton curve over a grid of 1024^3 cells; equal cells by id.
std::vector<std::uint32_t> morton_order(const std::vector<Patch>& patches) {
  const Eigen::AlignedBox3f box = bounds_of(patches);
  const float extent = box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
  const float scale = extent > 0 ? 1023.0f / extent : 0.0f;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keyed(patches.size());
  for (std::uint32_t i = 0; i < patches.size(); ++i) {
    std::uint32_t key = 0;
    if (is_finite(patches[i].centroid)) {
      const Eigen::Vector3f cell = (patches[i].centroid - box.min()) * scale;
      key = spread(static_cast<std::uint32_t>(cell.x())) |
            spread(static_cast<std::uint32_t>(cell.y())) << 1 |
            spread(static_cast<std::uint32_t>(cell.z())) << 2;
    }
    keyed[i] = {key, i};
  }
  tbb::parallel_sort(keyed.begin(), keyed.end());  // pairs are unique: one order only
  std::vector<std::uint32_t> order(patches.size());
  std::transform(keyed.begin(), keyed.end(), order.begin(), [](const auto& k) { return k.second; });
  return order;
}

}  // namespace

PatchIndex::PatchIndex(const std::vector<Patch>& patches) {
  for (const std::uint32_t id : morton_order(patches)) add(id, patches[id]);
  finish();
}

PatchIndex PatchIndex::sample(std::size_t count, std::uint64_t seed) const {
  if (count >= size()) return *this;
  std::mt19937_64 random(seed);
  PatchIndex part;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t begin = k * size() / count, end = (k + 1) * size() / count;
    const std::size_t i = begin + uniform_index(random, end - begin);
    part.add(patch_[i], {.centroid = centroid(i),
                         .normal = normal(i),
                         .curvature = curvature_[i],
                         .area = area_[i],
                         .scale = scale_[i]});
  }
  part.finish();
  return part;
}

void PatchIndex::add(std::uint32_t id, const Patch& patch) {
  x_.push_back(patch.centroid.x());
  y_.push_back(patch.centroid.y());
  z_.push_back(patch.centroid.z());
  nx_.push_back(patch.normal.x());
  ny_.push_back(patch.normal.y());
  nz_.push_back(patch.normal.z());
  area_.push_back(patch.area);
  curvature_.push_back(patch.curvature);
  scale_.push_back(patch.scale);
  patch_.push_back(id);
}

void PatchIndex::finish() {
  for (std::size_t begin = 0; begin < size(); begin += kBlock) {
    Eigen::AlignedBox3f box;
    float scale = 0;
    for (std::size_t i = begin; i < std::min(begin + kBlock, size()); ++i) {
      scale = std::max(scale, scale_[i]);
      if (is_finite(centroid(i))) box.extend(centroid(i));
    }
    if (box.isEmpty()) box.extend(Eigen::Vector3f::Zero());
    // A little more than the box: rounding must not turn an inlier away.
    const float slack = 1e-5f * (1.0f + box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()).sum());
    const Eigen::Vector3f half = 0.5f * box.sizes() + Eigen::Vector3f::Constant(slack);
    blocks_.push_back({box.center(), half, scale});
  }
  const std::size_t padded = blocks_.size() * kBlock;
  for (auto* column : {&x_, &y_, &z_, &area_, &scale_}) column->resize(padded, 0.0f);
  // A normal that is no number passes no gate.
  const float never = std::numeric_limits<float>::quiet_NaN();
  for (auto* column : {&nx_, &ny_, &nz_}) column->resize(padded, never);
}

bool PatchIndex::may_hold(const Block& block, const InlierTest& test) const {
  const float reach = test.plane.normal.cwiseAbs().dot(block.half) + test.half_width * block.scale;
  if (std::abs(test.plane.signed_distance(block.center)) > reach) return false;
  const Eigen::Vector3f gap = (block.center - test.center).cwiseAbs() - block.half;
  return gap.maxCoeff() <= test.radius;
}

template <bool kLocal>
std::uint64_t PatchIndex::test_block(const Columns& block, const InlierTest& test) const {
  const Float4 a(test.plane.normal.x()), b(test.plane.normal.y()), c(test.plane.normal.z());
  const Float4 d(test.plane.distance), width(test.half_width), gate(test.gate);
  const Float4 cx(test.center.x()), cy(test.center.y()), cz(test.center.z());
  const Float4 radius2(test.radius * test.radius);
  std::uint64_t word = 0;
  for (std::size_t j = 0; j < kBlock; j += 4) {
    const Float4 x = Float4::load(block.x + j), y = Float4::load(block.y + j),
                 z = Float4::load(block.z + j);
    const Float4 nx = Float4::load(block.nx + j), ny = Float4::load(block.ny + j),
                 nz = Float4::load(block.nz + j);
    const Float4 r = abs(a * x + b * y + c * z - d);
    const Float4 cosine = abs(a * nx + b * ny + c * nz);
    Float4 in = (r < width * Float4::load(block.scale + j)) & (cosine >= gate);
    if constexpr (kLocal) {
      const Float4 u = x - cx, v = y - cy, w = z - cz;
      in = in & (u * u + v * v + w * w <= radius2);
    }
    word |= std::uint64_t{sign_bits(in)} << j;
  }
  return word;
}

Bits PatchIndex::inliers(const InlierTest& test) const {
  const bool local = std::isfinite(test.radius);
  Bits found(blocks_.size(), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!may_hold(blocks_[b], test)) continue;
    found[b] = local ? test_block<true>(columns(b), test) : test_block<false>(columns(b), test);
  }
  return found;
}

}  // namespace planescope
