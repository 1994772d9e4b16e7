// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "patches/grid_bounds.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "planescope/error.hpp"
#include "simd.hpp"

namespace planescope {
namespace {

using Range = tbb::blocked_range<std::size_t>;
constexpr std::size_t kGrain = 16384;

/// Bounds of the finite points, four lanes at once: every run takes this pass.
GridBounds finite_bounds(const PointCloud& cloud) {
  struct Corners {
    Float4 lower{std::numeric_limits<float>::infinity()};
    Float4 upper{-std::numeric_limits<float>::infinity()};
  };
  const Corners corners = tbb::parallel_reduce(
      Range(0, cloud.size(), kGrain), Corners{},
      [&](const Range& range, Corners part) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const Float4 p = Float4::load3(cloud.positions[i].data());
          if (!is_finite3(p)) continue;
          part.lower = min(part.lower, p);
          part.upper = max(part.upper, p);
        }
        return part;
      },
      [](const Corners& a, const Corners& b) {
        return Corners{min(a.lower, b.lower), max(a.upper, b.upper)};
      });
  std::array<float, 4> lower{}, upper{};
  corners.lower.store(lower.data()), corners.upper.store(upper.data());
  return {{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
}

/// Bounds of the points that `takes` takes, and how many finite ones it does not.
template <class Takes>
GridBounds bounds_of(const PointCloud& cloud, const Takes& takes) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const GridBounds none{Eigen::Vector3f::Constant(kInfinity),
                        Eigen::Vector3f::Constant(-kInfinity)};
  return tbb::parallel_reduce(
      Range(0, cloud.size(), kGrain), none,
      [&](const Range& range, GridBounds bounds) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const Eigen::Vector3f& p = cloud.positions[i];
          if (!is_finite(p)) continue;
          if (!takes(p)) {
            ++bounds.strays;
            continue;
          }
          bounds.lower = bounds.lower.cwiseMin(p);
          bounds.upper = bounds.upper.cwiseMax(p);
        }
        return bounds;
      },
      [](const GridBounds& a, const GridBounds& b) {
        return GridBounds{a.lower.cwiseMin(b.lower), a.upper.cwiseMax(b.upper),
                          a.strays + b.strays};
      });
}

/// Every k-th finite point, so that a fixed number of them is spread over the file.
std::vector<Eigen::Vector3f> sample(const PointCloud& cloud) {
  constexpr std::size_t kSample = 65536;
  std::vector<Eigen::Vector3f> finite;
  std::ranges::copy_if(cloud.positions, std::back_inserter(finite), is_finite);
  if (finite.size() <= kSample) return finite;
  std::vector<Eigen::Vector3f> some(kSample);
  for (std::size_t i = 0; i < kSample; ++i) some[i] = finite[i * finite.size() / kSample];
  return some;
}

/// The 1st to 99th percentile along each axis, widened on every side by its longest extent and a
/// metre. In double: half the range of float may be beyond it.
struct Box {
  Eigen::Vector3d lower, upper;

  explicit Box(const std::vector<Eigen::Vector3f>& points) {
    std::vector<float> values(points.size());
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][axis];
      std::ranges::sort(values);
      const std::size_t few = values.size() / 100;
      lower[axis] = double(values[few]);
      upper[axis] = double(values[values.size() - 1 - few]);
    }
    const double margin = (upper - lower).maxCoeff() + 1;
    lower.array() -= margin;
    upper.array() += margin;
  }

  bool holds(const Eigen::Vector3f& p) const {
    const Eigen::Vector3d q = p.cast<double>();
    return (q.array() >= lower.array()).all() && (q.array() <= upper.array()).all();
  }
};

}  // namespace

GridBounds find_grid_bounds(const PointCloud& cloud, double longest) {
  GridBounds all = finite_bounds(cloud);
  if (!(all.lower.x() <= all.upper.x())) {
    throw Error(Error::Kind::Input, "the cloud has no finite point; expected at least one");
  }
  if (all.extent() <= longest) return all;
  const Box box(sample(cloud));
  const GridBounds most = bounds_of(cloud, [&](const Eigen::Vector3f& p) { return box.holds(p); });
  const bool few = most.strays <= cloud.size() / 100;
  return few && most.lower.x() <= most.upper.x() ? most : all;
}

}  // namespace planescope
