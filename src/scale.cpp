// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "patches/moments.hpp"
#include "patches/voxel_blocks.hpp"
#include "planescope/error.hpp"
#include "planescope/options.hpp"

namespace planescope {
namespace {

constexpr std::size_t kQueries = 1024;        // places at which density and noise are measured
constexpr std::size_t kExtentSample = 65536;  // points that give the extent's percentiles
constexpr float kWantedNeighbours = 24;  // points that a place should see: enough to fit a plane

std::vector<std::uint32_t> finite_indices(const PointCloud& cloud) {
  std::vector<std::uint32_t> finite;
  finite.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (is_finite(cloud.positions[i])) finite.push_back(static_cast<std::uint32_t>(i));
  }
  return finite;
}

// Every k-th point, so that organised and scan-ordered clouds are met evenly; a fixed sample needs
// no seed.
std::vector<std::uint32_t> every(const std::vector<std::uint32_t>& indices, std::size_t count) {
  if (indices.size() <= count) return indices;
  std::vector<std::uint32_t> sample(count);
  for (std::size_t i = 0; i < count; ++i) sample[i] = indices[i * indices.size() / count];
  return sample;
}

struct Percentiles {
  Eigen::Vector3f low, high;
};

Percentiles find_percentiles(const PointCloud& cloud, const std::vector<std::uint32_t>& sample) {
  Percentiles result;
  std::vector<float> values(sample.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < sample.size(); ++i) values[i] = cloud.positions[sample[i]][axis];
    std::sort(values.begin(), values.end());
    result.low[axis] = values[values.size() / 100];
    result.high[axis] = values[values.size() - 1 - values.size() / 100];
  }
  return result;
}

// Integer cells of edge `size`, wide enough for any float cloud (clamped: an outlier only loses its
// neighbours).
std::uint64_t cell_key(const Eigen::Vector3f& p, const Eigen::Vector3f& low, float inverse, int dx,
                       int dy, int dz) {
  const auto axis = [&](int a, int d) {
    const double cell = std::floor(double(p[a] - low[a]) * double(inverse)) + d;
    return static_cast<std::uint64_t>(std::clamp(cell, -1048576.0, 1048575.0) + 1048576.0);
  };
  return axis(2, dz) << 42 | axis(1, dy) << 21 | axis(0, dx);
}

// The surface's area by counting cells of a hundredth of the extent: rough, but it only sets the
// search radius.
float rough_spacing(const PointCloud& cloud, const std::vector<std::uint32_t>& sample,
                    std::size_t points, const Percentiles& box) {
  const float cell = std::max((box.high - box.low).norm() / 100, 1e-6f);
  BlockMap cells;
  for (const std::uint32_t i : sample)
    cells.insert(cell_key(cloud.positions[i], box.low, 1 / cell, 0, 0, 0));
  return cell * std::sqrt(float(cells.keys().size()) / float(points));
}

// What each place saw within the radius: moments about the place.
struct Place {
  Eigen::Vector3f position;
  Moments moments;
};

// The places whose radius may reach into a cell, in compressed rows by cell.
struct PlaceIndex {
  BlockMap cells;
  std::vector<std::vector<std::uint32_t>> places;
};

PlaceIndex index_places(const std::vector<Place>& places, const Eigen::Vector3f& low,
                        float radius) {
  PlaceIndex index;
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    for (int i = 0; i < 27; ++i) {
      const std::uint64_t key =
          cell_key(places[p].position, low, 1 / radius, i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const std::uint32_t cell = index.cells.insert(key);
      if (cell == index.places.size()) index.places.emplace_back();
      index.places[cell].push_back(p);
    }
  }
  return index;
}

void look_around(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                 const Eigen::Vector3f& low, float radius, std::vector<Place>& places) {
  const PlaceIndex index = index_places(places, low, radius);
  struct Hit {
    std::uint32_t place, point;
  };
  constexpr std::size_t kChunk =
      65536;  // fixed chunks, joined in order: sums do not depend on threads
  std::vector<std::vector<Hit>> hits((finite.size() + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t chunk) {
    const std::size_t end = std::min(finite.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const Eigen::Vector3f& p = cloud.positions[finite[i]];
      const std::uint32_t cell = index.cells.find(cell_key(p, low, 1 / radius, 0, 0, 0));
      if (cell == BlockMap::kAbsent) continue;
      for (const std::uint32_t place : index.places[cell]) {
        if ((p - places[place].position).squaredNorm() <= radius * radius)
          hits[chunk].push_back({place, finite[i]});
      }
    }
  });
  for (const auto& chunk : hits) {
    for (const Hit& hit : chunk) {
      places[hit.place].moments.add(cloud.positions[hit.point] - places[hit.place].position);
    }
  }
}

float median(std::vector<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Root mean square distance to the fitted plane, corrected for the three parameters that the fit
// used up.
float plane_noise(const Moments& m) {
  const Eigen::Vector3f mean = m.first / m.count;
  const float variance = (m.xx + m.yy + m.zz) / m.count - mean.squaredNorm();
  const float smallest = principal_plane(m).curvature * std::max(variance, 0.0f);
  return std::sqrt(smallest * m.count / (m.count - 3));
}

}  // namespace

CloudScale measure_scale(const PointCloud& cloud) {
  const std::vector<std::uint32_t> finite = finite_indices(cloud);
  if (finite.empty()) {
    throw Error(Error::Kind::Input, "the cloud has no finite point; expected at least one");
  }
  CloudScale scale;
  scale.finite_points = finite.size();
  const std::vector<std::uint32_t> sample = every(finite, kExtentSample);
  const Percentiles box = find_percentiles(cloud, sample);
  scale.extent = box.high - box.low;

  float spacing = rough_spacing(cloud, sample, finite.size(), box);
  std::vector<float> densities, noises;
  // The first look corrects the radius, the second measures with it.
  for (int look = 0; look < 2; ++look) {
    const float radius = spacing * std::sqrt(kWantedNeighbours / std::numbers::pi_v<float>);
    std::vector<Place> places;
    for (const std::uint32_t i : every(finite, kQueries))
      places.push_back({cloud.positions[i], {}});
    look_around(cloud, finite, box.low, std::max(radius, 1e-6f), places);
    densities.clear();
    noises.clear();
    for (const Place& place : places) {
      densities.push_back(
          radius * std::sqrt(std::numbers::pi_v<float> / std::max(place.moments.count, 1.0f)));
      if (place.moments.count >= 8) noises.push_back(plane_noise(place.moments));
    }
    spacing = std::max(median(densities), 1e-6f);
  }
  scale.spacing = double(spacing);
  scale.noise = double(median(noises));
  return scale;
}

}  // namespace planescope
