// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/voxel_normals.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/moments.hpp"
#include "simd.hpp"

namespace planescope {
namespace {

constexpr std::size_t kGrain = 1024;  // voxels a task

// Ten moments about a voxel's own mean (see Moments), laid out for four lanes.
struct Sums {
  Float4 first;     // x, y, z, count
  Float4 squares;   // xx, yy, zz, -
  Float4 products;  // xy, yz, zx, -

  void add(Float4 q) {  // its last lane is 1
    first += q;
    squares += q * q;
    products += q * yzxw(q);
  }

  // Adds a set whose reference lies at `d` from ours; the last lane of d is 0.
  void add_shifted(const Sums& other, Float4 d) {
    const Float4 s = other.first, t = s + wwww(s) * d;
    first += t;
    squares += other.squares + (s + t) * d;
    products += other.products + s * yzxw(d) + yzxw(t) * d;
  }

  Moments moments() const {
    std::array<float, 4> f{}, q{}, p{};
    first.store(f.data()), squares.store(q.data()), products.store(p.data());
    return {.count = f[3],
            .first = {f[0], f[1], f[2]},
            .xx = q[0],
            .xy = p[0],
            .xz = p[2],
            .yy = q[1],
            .yz = p[1],
            .zz = q[2]};
  }
};

using StoredSums = std::array<float, 12>;

void store(const Sums& sums, StoredSums& to) {
  sums.first.store(&to[0]), sums.squares.store(&to[4]), sums.products.store(&to[8]);
}

Sums load(const StoredSums& from) {
  return {Float4::load(&from[0]), Float4::load(&from[4]), Float4::load(&from[8])};
}

// The smallest root of the characteristic polynomial of a positive semidefinite matrix of trace 1,
// l^3 - l^2 + b l - c: Newton's steps from 0 rise towards it, and square the error once it is near.
// Six leave less than 1e-6 of it where the two smaller roots differ by a tenth.
Float4 smallest_root(Float4 b, Float4 c) {
  constexpr int kSteps = 6;
  const Float4 one(1.0f), two(2.0f), three(3.0f);
  Float4 l;
  for (int step = 0; step < kSteps; ++step) {
    const Float4 value = ((l - one) * l + b) * l - c;
    const Float4 slope = (three * l - two) * l + b;
    l = l - value / slope;
  }
  return l;
}

struct Vector4 {  // four vectors
  Float4 x, y, z;
  friend Vector4 cross(const Vector4& a, const Vector4& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Float4 dot(const Vector4& a, const Vector4& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  friend Vector4 select(Float4 mask, const Vector4& a, const Vector4& b) {
    return {select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
  }
};

// The normals of four sets: principal_plane() in single precision, which is good to 1e-4 radians
// where the result says so (bit by bit) and to 1e-6 almost everywhere.
unsigned four_normals(std::array<Sums, 4> sums, Vector4& normal) {
  transpose(sums[0].first, sums[1].first, sums[2].first, sums[3].first);
  transpose(sums[0].squares, sums[1].squares, sums[2].squares, sums[3].squares);
  transpose(sums[0].products, sums[1].products, sums[2].products, sums[3].products);
  const Float4 one(1.0f), count = sums[3].first, w = one / count;
  const Float4 mx = sums[0].first * w, my = sums[1].first * w, mz = sums[2].first * w;
  Float4 xx = sums[0].squares * w - mx * mx, yy = sums[1].squares * w - my * my,
         zz = sums[2].squares * w - mz * mz;
  const Float4 trace = xx + yy + zz, s = one / trace;
  xx = s * xx, yy = s * yy, zz = s * zz;
  const Float4 xy = s * (sums[0].products * w - mx * my), yz = s * (sums[1].products * w - my * mz),
               zx = s * (sums[2].products * w - mz * mx);
  const Float4 minors = (xx * yy - xy * xy) + (yy * zz - yz * yz) + (zz * xx - zx * zx);
  const Float4 determinant =
      xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * zx) + zx * (xy * yz - yy * zx);
  const Float4 l = smallest_root(minors, max(determinant, Float4(0.0f)));
  // The longest cross product of two rows of M - l I.
  const Vector4 r0{xx - l, xy, zx}, r1{xy, yy - l, yz}, r2{zx, yz, zz - l};
  normal = cross(r0, r1);
  Float4 length = dot(normal, normal);
  for (const Vector4& candidate : {cross(r0, r2), cross(r1, r2)}) {
    const Float4 square = dot(candidate, candidate), longer = length < square;
    normal = select(longer, candidate, normal);
    length = max(square, length);
  }
  const Float4 scale = one / sqrt(length);
  normal = {normal.x * scale, normal.y * scale, normal.z * scale};
  // About (l1 - l0)^2 (l2 - l0)^2: under this, rounding turns the normal.
  const Float4 sure =
      (length >= Float4(1e-6f)) & (count >= Float4(3.0f)) & (trace >= Float4(1e-20f));
  return sign_bits(sure);
}

// Writes the normals of `count` (up to four) sets.
void write_normals(const std::array<Sums, 4>& sums, std::size_t count, Eigen::Vector3f* to) {
  Vector4 normal;
  const unsigned sure = four_normals(sums, normal);
  std::array<float, 4> x{}, y{}, z{};
  normal.x.store(x.data()), normal.y.store(y.data()), normal.z.store(z.data());
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = (sure >> i & 1) != 0 ? Eigen::Vector3f(x[i], y[i], z[i])
                                 : principal_plane(sums[i].moments()).normal;
  }
}

template <typename Body>
void for_ranges(std::size_t size, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, kGrain),
                    [&](const auto& range) { body(range.begin(), range.end()); });
}

}  // namespace

std::vector<Eigen::Vector3f> estimate_voxel_normals(const VoxelGrid& grid,
                                                    const std::vector<Eigen::Vector3f>& mean) {
  const std::uint32_t *offsets = grid.neighbour_offsets.data(),
                      *neighbours = grid.neighbours.data();
  const auto at = [&](std::size_t v) { return Float4::load3(mean[v].data()); };
  constexpr std::array<float, 4> kCount = {0, 0, 0, 1};
  const Float4 counted = Float4::load(kCount.data());
  // S(m), each about its voxel's own mean; the largest array of all, and each part of it is written
  // first by the thread that needs it.
  const auto ring = std::make_unique_for_overwrite<StoredSums[]>(grid.voxel_count());
  for_ranges(grid.voxel_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Sums sum{.first = counted, .squares = {}, .products = {}};  // the voxel itself
      const Float4 origin = at(v) - counted;
      for (std::size_t k = offsets[v]; k < offsets[v + 1]; ++k) sum.add(at(neighbours[k]) - origin);
      store(sum, ring[v]);
    }
  });
  std::vector<Eigen::Vector3f> normals(grid.voxel_count());
  for_ranges(grid.voxel_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += 4) {
      const std::size_t count = std::min<std::size_t>(4, end - first);
      std::array<Sums, 4> sums;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t v = first + std::min(i, count - 1);
        const Sums own = load(ring[v]);
        Sums sum = own;
        sum.add_shifted(own, Float4());  // S(m) once more, as its own part of S(S(m))
        sum.first += counted;            // m
        const Float4 origin = at(v);
        for (std::size_t k = offsets[v]; k < offsets[v + 1]; ++k)
          sum.add_shifted(load(ring[neighbours[k]]), at(neighbours[k]) - origin);
        sums[i] = sum;
      }
      write_normals(sums, count, &normals[first]);
    }
  });
  return normals;
}

}  // namespace planescope
