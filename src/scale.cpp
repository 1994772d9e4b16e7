// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <span>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "connected_voxel.hpp"
#include "patches/moments.hpp"
#include "patches/voxel_blocks.hpp"
#include "planescope/error.hpp"
#include "planescope/options.hpp"
#include "single_scan.hpp"

namespace planescope {
namespace {

constexpr std::size_t kQueries = 1024;        // places at which density and noise are measured
constexpr std::size_t kExtentSample = 65536;  // points that give the extent's percentiles
// The smallest voxels, in spacings: the samples of one view lie the further apart the further away,
// those of a map evenly.
constexpr double kViewVoxel = 1.5, kMapVoxel = 1.05;
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

// Each position once: in a heap of equal points all places would see the same.
std::vector<std::uint32_t> distinct(const PointCloud& cloud, std::vector<std::uint32_t> indices) {
  const auto position = [&](std::uint32_t i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    return std::array{p.x(), p.y(), p.z()};
  };
  std::set<std::array<float, 3>> known;
  std::erase_if(indices, [&](std::uint32_t i) { return !known.insert(position(i)).second; });
  return indices;
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
    // What is no number, between points at the ends of float's range, goes to the lowest cell.
    const double bounded = cell >= -1048576.0 ? std::min(cell, 1048575.0) : -1048576.0;
    return static_cast<std::uint64_t>(bounded + 1048576.0);
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

// The places whose radius may reach into a cell, by cell.
struct PlaceIndex {
  BlockMap cells;
  std::vector<std::vector<std::uint32_t>> places;
};

PlaceIndex index_places(const PointCloud& cloud, const std::vector<std::uint32_t>& places,
                        const Eigen::Vector3f& low, float radius) {
  PlaceIndex index;
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    for (int i = 0; i < 27; ++i) {
      const std::uint64_t key = cell_key(cloud.positions[places[p]], low, 1 / radius, i % 3 - 1,
                                         i / 3 % 3 - 1, i / 9 - 1);
      const std::uint32_t cell = index.cells.insert(key);
      if (cell == index.places.size()) index.places.emplace_back();
      index.places[cell].push_back(p);
    }
  }
  return index;
}

struct Hit {
  std::uint32_t place, point;
};
constexpr std::size_t kChunk = 65536;  // fixed, joined in order: sums do not depend on threads

// What the places see of one chunk of the points. A place that sees thousands of points of one
// chunk stands in a heap of equal ones: that is counted no further, or heaps would take all memory.
std::vector<Hit> find_hits(const PointCloud& cloud, std::span<const std::uint32_t> points,
                           const std::vector<std::uint32_t>& places, const PlaceIndex& index,
                           const Eigen::Vector3f& low, float radius) {
  constexpr std::uint32_t kMostSeen = 8192;
  std::vector<Hit> hits;
  std::vector<std::uint32_t> seen(places.size(), 0);
  for (const std::uint32_t i : points) {
    const Eigen::Vector3f& p = cloud.positions[i];
    const std::uint32_t cell = index.cells.find(cell_key(p, low, 1 / radius, 0, 0, 0));
    if (cell == BlockMap::kAbsent) continue;
    for (const std::uint32_t place : index.places[cell]) {
      const float distance = (p - cloud.positions[places[place]]).squaredNorm();
      if (distance <= radius * radius && ++seen[place] <= kMostSeen) hits.push_back({place, i});
    }
  }
  return hits;
}

// What each place sees within the radius: moments about the place.
std::vector<Moments> look_around(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                                 const std::vector<std::uint32_t>& places,
                                 const Eigen::Vector3f& low, float radius) {
  const PlaceIndex index = index_places(cloud, places, low, radius);
  constexpr std::size_t kGroup = 8 * kChunk;  // hits of so many points are kept at a time
  std::vector<Moments> seen(places.size());
  for (std::size_t begin = 0; begin < finite.size(); begin += kGroup) {
    const std::size_t size = std::min(kGroup, finite.size() - begin);
    std::vector<std::vector<Hit>> hits((size + kChunk - 1) / kChunk);
    tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t chunk) {
      const auto first = finite.begin() + static_cast<std::ptrdiff_t>(begin + chunk * kChunk);
      const auto last = finite.begin() +
                        static_cast<std::ptrdiff_t>(begin + std::min(size, (chunk + 1) * kChunk));
      hits[chunk] = find_hits(cloud, {first, last}, places, index, low, radius);
    });
    for (const auto& chunk : hits) {
      for (const Hit& hit : chunk)
        seen[hit.place].add(cloud.positions[hit.point] - cloud.positions[places[hit.place]]);
    }
  }
  return seen;
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

// The radius at which a place of a surface sees enough points.
float reach(float spacing) {
  return std::max(spacing * std::sqrt(kWantedNeighbours / std::numbers::pi_v<float>), 1e-6f);
}

float find_spacing(const std::vector<Moments>& seen, float radius) {
  std::vector<float> spacings;
  spacings.reserve(seen.size());
  for (const Moments& m : seen) {
    spacings.push_back(radius * std::sqrt(std::numbers::pi_v<float> / std::max(m.count, 1.0f)));
  }
  return std::max(median(std::move(spacings)), 1e-6f);
}

float find_noise(const std::vector<Moments>& seen) {
  std::vector<float> noises;
  for (const Moments& m : seen) {
    if (m.count >= 8) noises.push_back(plane_noise(m));
  }
  return median(std::move(noises));
}

double depth_noise(const PointCloud& cloud, const std::vector<std::uint32_t>& places) {
  if (!cloud.organised() || !cloud.sensor) return 0;
  std::vector<float> depths;
  depths.reserve(places.size());
  for (const std::uint32_t i : places)
    depths.push_back(std::abs(cloud.positions[i].z() - cloud.sensor->z()));
  const auto z = double(median(std::move(depths)));
  return 0.0014 * z * z;
}

// Where the cloud was seen from, if from one place: the middle and the far end of what was seen.
void find_ranges(const PointCloud& cloud, const std::vector<std::uint32_t>& finite,
                 const std::vector<std::uint32_t>& places, const std::vector<Moments>& seen,
                 CloudScale& scale) {
  const Eigen::Vector3f sensor = cloud.sensor.value_or(-cloud.origin.cast<float>());
  std::vector<Sighting> sightings(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    sightings[k] = {(cloud.positions[places[k]] - sensor).norm(), seen[k].count};
  }
  const bool view = cloud.organised() && cloud.sensor;
  if (!view && !is_single_scan(cloud, finite, sightings, sensor)) return;
  std::sort(sightings.begin(), sightings.end(),
            [](const auto& a, const auto& b) { return a.range < b.range; });
  scale.median_range = double(sightings[sightings.size() / 2].range);
  scale.far_range = double(sightings[sightings.size() * 9 / 10].range);
}

// A surfel is the mean of what lay within its radius, so that voxels finer than that hold nothing
// finer. Radii of several spacings are no radii in metres.
double surfel_radius(const PointCloud& cloud, const std::vector<std::uint32_t>& sample,
                     double spacing) {
  constexpr double kWidest = 4;  // [spacings]
  std::vector<float> radii;
  for (const std::uint32_t i : sample) {
    if (cloud.has_radii() && std::isfinite(cloud.radii[i])) radii.push_back(cloud.radii[i]);
  }
  const auto radius = double(median(std::move(radii)));
  return radius > kWidest * spacing ? 0 : radius;
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

  const std::vector<std::uint32_t> queries = distinct(cloud, every(finite, kQueries));
  const auto look = [&](float radius) {
    return look_around(cloud, finite, queries, box.low, radius);
  };
  float spacing = rough_spacing(cloud, sample, finite.size(), box);
  spacing = find_spacing(look(reach(spacing)), reach(spacing));  // corrects the radius ...
  float radius = reach(spacing);
  std::vector<Moments> seen = look(radius);
  spacing = find_spacing(seen, radius);  // ... that this one measures with
  float noise = find_noise(seen);
  // A plane through points that noise scatters as widely as the radius fits anything: look further.
  constexpr int kMoreLooks = 3;
  for (int k = 0; k < kMoreLooks && noise > 0.15f * radius; ++k) {
    radius *= 2;
    noise = find_noise(look(radius));
  }
  scale.spacing = double(spacing);
  scale.noise = std::max(double(noise), depth_noise(cloud, queries));
  find_ranges(cloud, finite, queries, seen, scale);
  const bool map = !cloud.organised() && scale.median_range == 0;
  const double smallest = std::max((map ? kMapVoxel : kViewVoxel) * scale.spacing,
                                   surfel_radius(cloud, sample, scale.spacing));
  scale.connected_voxel = find_connected_voxel(cloud, smallest, scale.median_range);
  return scale;
}

}  // namespace planescope
