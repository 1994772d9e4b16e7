// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"

namespace planescope {
namespace {

/// Points by cells of a grid, each at least as wide as the distance that is searched.
class CellIndex {
 public:
  CellIndex(const PointCloud& cloud, double cell) : cell_(cell) {
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (!is_finite(cloud.positions[i])) continue;
      const Eigen::Vector3d p = cloud.origin + cloud.positions[i].cast<double>();
      entries_.push_back({key(place(p)), p, cloud.labels[i], i});
    }
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
      return a.key != b.key ? a.key < b.key : a.index < b.index;
    });
  }

  struct Found {
    double squared = std::numeric_limits<double>::infinity();
    std::uint32_t label = 0;
    std::size_t index = 0;
  };

  /// The nearest point within one cell's width.
  Found find(const Eigen::Vector3d& p) const {
    Found best;
    const Cell c = place(p);
    for (std::int64_t n = 0; n < 27; ++n) {
      const Cell near = {c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1};
      const Key wanted = key(near);
      auto it = std::ranges::lower_bound(entries_, wanted, {}, &Entry::key);
      for (; it != entries_.end() && it->key == wanted; ++it) {
        const double squared = (it->position - p).squaredNorm();
        const bool first = squared == best.squared && it->index < best.index;
        if (squared < best.squared || first) best = {squared, it->label, it->index};
      }
    }
    return best;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  using Key = Cell;
  struct Entry {
    Key key;
    Eigen::Vector3d position;
    std::uint32_t label;
    std::size_t index;
  };

  Cell place(const Eigen::Vector3d& p) const {
    const auto part = [&](double v) { return static_cast<std::int64_t>(std::floor(v / cell_)); };
    return {part(p.x()), part(p.y()), part(p.z())};
  }
  static Key key(const Cell& cell) { return {cell[2], cell[1], cell[0]}; }

  double cell_;
  std::vector<Entry> entries_;
};

}  // namespace

NearestLabels nearest_labels(const PointCloud& truth, const PointCloud& cloud,
                             double max_distance) {
  if (!(max_distance > 0)) {
    throw Error(Error::Kind::Usage, "nearest_labels: the distance is to be more than 0 m");
  }
  if (!truth.has_labels()) {
    throw Error(Error::Kind::Input, "nearest_labels: the truth has no labels");
  }
  const CellIndex index(truth, max_distance);
  std::vector<double> distance(cloud.size(), -1);  // -1: no point, -2: none near
  NearestLabels nearest;
  nearest.labels.assign(cloud.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      if (!is_finite(cloud.positions[i])) continue;
      const auto found = index.find(cloud.origin + cloud.positions[i].cast<double>());
      const double d = std::sqrt(found.squared);
      distance[i] = d <= max_distance ? d : -2;
      if (d <= max_distance) nearest.labels[i] = found.label;
    }
  });
  std::size_t count = 0;
  double sum = 0;
  for (const double d : distance) {
    nearest.beyond += d == -2 ? 1 : 0;
    if (d < 0) continue;
    sum += d;
    ++count;
  }
  nearest.mean_distance = count > 0 ? sum / static_cast<double>(count) : 0;
  return nearest;
}

}  // namespace planescope
