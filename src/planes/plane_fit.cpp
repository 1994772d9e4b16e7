// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_fit.hpp"

#include <algorithm>
#include <bit>

#include <Eigen/Eigenvalues>

#include "simd.hpp"

namespace planescope {
namespace {

/// Weighted moments of centroids about a point near them, in double: a difference of large squares
/// would lose the plane.
struct Moments {
  double weight = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();  ///< on the side of the previous normal
};

/// The same of one block of patches about the block's centre, four patches at once; near their own
/// centre single precision holds them.
class BlockMoments {
 public:
  BlockMoments(const PatchIndex::Columns& block, const Plane& previous, double sigma)
      : block_(block),
        a_(previous.normal.x()),
        b_(previous.normal.y()),
        c_(previous.normal.z()),
        offset_(-previous.signed_distance(block.center)),
        sigma_(static_cast<float>(sigma)) {}

  /// The members among the four patches from position j of the block on.
  void add(std::size_t j, unsigned members) {
    constexpr float kLeast = 1e-6f;  // [m^2] a patch without area still has a say
    const Float4 in = lane_mask(members), one(1.0f);
    const Float4 x = in & (Float4::load(block_.x + j) - Float4(block_.center.x()));
    const Float4 y = in & (Float4::load(block_.y + j) - Float4(block_.center.y()));
    const Float4 z = in & (Float4::load(block_.z + j) - Float4(block_.center.z()));
    const Float4 nx = in & Float4::load(block_.nx + j), ny = in & Float4::load(block_.ny + j),
                 nz = in & Float4::load(block_.nz + j);
    const Float4 r =
        (a_ * x + b_ * y + c_ * z - offset_) / (sigma_ * Float4::load(block_.scale + j));
    // Tukey's biweight of a residual in units of the inlier distance: 1 on the plane, 0 at sigma.
    const Float4 rest = max(Float4(0.0f), one - r * r);
    const Float4 w = in & (max(Float4::load(block_.area + j), Float4(kLeast)) * rest * rest);
    const Float4 side = w ^ ((a_ * nx + b_ * ny + c_ * nz) & Float4(-0.0f));
    const Float4 wx = w * x, wy = w * y, wz = w * z;
    weight_ += w;
    x_ += wx, y_ += wy, z_ += wz;
    xx_ += wx * x, xy_ += wx * y, xz_ += wx * z;
    yy_ += wy * y, yz_ += wy * z, zz_ += wz * z;
    nx_ += side * nx, ny_ += side * ny, nz_ += side * nz;
  }

  /// Adds them up to moments about `shift`.
  void add_to(Moments& m, const Eigen::Vector3d& shift) const {
    const Eigen::Vector3d d = block_.center.cast<double>() - shift;
    const double w = vector(weight_, weight_, weight_).x();
    const Eigen::Vector3d s = vector(x_, y_, z_);
    m.weight += w;
    m.sum += s + w * d;
    Eigen::Matrix3d outer;
    outer.row(0) = vector(xx_, xy_, xz_);
    outer.row(1) = vector(xy_, yy_, yz_);
    outer.row(2) = vector(xz_, yz_, zz_);
    m.outer += outer + s * d.transpose() + d * s.transpose() + w * d * d.transpose();
    m.normals += vector(nx_, ny_, nz_);
  }

 private:
  static Eigen::Vector3d vector(Float4 x, Float4 y, Float4 z) {
    return {double{sum(x)}, double{sum(y)}, double{sum(z)}};
  }

  const PatchIndex::Columns& block_;
  const Float4 a_, b_, c_, offset_, sigma_;
  Float4 weight_, x_, y_, z_, xx_, xy_, xz_, yy_, yz_, zz_, nx_, ny_, nz_;
};

Moments moments_of(const PatchIndex& index, const Bits& members, const Eigen::Vector3d& shift,
                   const Plane& previous, double sigma) {
  Moments m;
  for (std::size_t word = 0; word < members.size(); ++word) {
    if (members[word] == 0) continue;
    const PatchIndex::Columns block = index.columns(word);
    BlockMoments sums(block, previous, sigma);
    for (std::size_t j = 0; j < 64; j += 4) {
      const auto four = static_cast<unsigned>(members[word] >> j & 15);
      if (four != 0) sums.add(j, four);
    }
    sums.add_to(m, shift);
  }
  return m;
}

Plane through(const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  return {normal.cast<float>(), static_cast<float>(normal.dot(point))};
}

}  // namespace

Plane orient_plane(const PatchIndex& index, const Bits& members, const Plane& plane) {
  const Float4 a(plane.normal.x()), b(plane.normal.y()), c(plane.normal.z());
  std::int64_t votes = 0;
  for (std::size_t word = 0; word < members.size(); ++word) {
    if (members[word] == 0) continue;
    const PatchIndex::Columns block = index.columns(word);
    std::uint64_t against = 0;
    for (std::size_t j = 0; j < 64; j += 4) {
      const Float4 dot = a * Float4::load(block.nx + j) + b * Float4::load(block.ny + j) +
                         c * Float4::load(block.nz + j);
      against |= std::uint64_t{sign_bits(dot < Float4(0.0f))} << j;
    }
    votes += std::popcount(members[word]) - 2 * std::popcount(members[word] & against);
  }
  return votes < 0 ? Plane{-plane.normal, -plane.distance} : plane;
}

Plane fit_plane(const PatchIndex& index, const Bits& members, const Plane& previous, double sigma) {
  const auto first = std::find_if(members.begin(), members.end(), [](auto w) { return w != 0; });
  if (first == members.end()) return previous;
  const auto word = static_cast<std::size_t>(first - members.begin());
  const std::size_t any = word * 64 + static_cast<std::size_t>(std::countr_zero(*first));
  const Eigen::Vector3d shift = index.centroid(any).cast<double>();
  const Moments m = moments_of(index, members, shift, previous, sigma);
  if (!(m.weight > 0)) return previous;
  const Eigen::Vector3d mean = m.sum / m.weight;
  const Eigen::Matrix3d covariance = m.outer / m.weight - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> pca(covariance);
  const bool fixed = pca.eigenvalues()(1) > sigma * sigma;
  Eigen::Vector3d normal = fixed ? Eigen::Vector3d(pca.eigenvectors().col(0)) : m.normals;
  if (normal.norm() == 0) normal = previous.normal.cast<double>();
  if (normal.dot(previous.normal.cast<double>()) < 0) normal = -normal;
  return through(normal.normalized(), mean + shift);
}

}  // namespace planescope
