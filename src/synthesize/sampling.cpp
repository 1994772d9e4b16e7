// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/sampling.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planescope::synthesis {
namespace {

constexpr std::uint64_t kSampling = 3;        // stream of the seed
constexpr std::uint64_t kChunk = 1ull << 16;  // points with a generator of their own

using Occluders = std::vector<std::vector<std::uint32_t>>;

// A run of points on one surface.
struct Chunk {
  std::size_t surface = 0;
  std::uint64_t first = 0, count = 0;  // of the cloud's points
  double free_share = 1;               // of the surface
};

// Even candidates on the unit square: the R2 sequence (a Kronecker lattice of the plastic number;
// M. Roberts 2018), shifted, and jittered by half its spacing so that no lattice shows.
class EvenSequence {
 public:
  EvenSequence(Random& random, double expected)
      : random_(random),
        u_(random.uniform()),
        v_(random.uniform()),
        jitter_(0.5 / std::sqrt(expected)) {}

  Vector2d next() {
    u_ = wrap(u_ + 0.7548776662466927);
    v_ = wrap(v_ + 0.5698402909980532);
    const double du = random_.uniform(-jitter_, jitter_);
    return {wrap(u_ + du), wrap(v_ + random_.uniform(-jitter_, jitter_))};
  }

 private:
  static double wrap(double x) { return x - std::floor(x); }

  Random& random_;
  double u_, v_, jitter_;
};

std::vector<VisiblePart> find_visible_parts(const Scene& scene, const Occluders& occluders) {
  std::vector<VisiblePart> parts(scene.surfaces().size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t s) {
    parts[s] = scene.visible_part(scene.surfaces()[s], occluders[s]);
  });
  return parts;
}

std::vector<Chunk> divide_points(const Scene& scene, const std::vector<VisiblePart>& parts,
                                 std::uint64_t points) {
  std::vector<double> areas(parts.size());
  std::transform(parts.begin(), parts.end(), areas.begin(),
                 [](const VisiblePart& part) { return part.area; });
  const std::vector<std::uint64_t> counts = apportion(points, areas);
  std::vector<Chunk> chunks;
  std::uint64_t first = 0;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const double share = areas[s] / scene.surfaces()[s].geometry.area();
    for (std::uint64_t done = 0; done < counts[s]; done += kChunk) {
      const std::uint64_t count = std::min(kChunk, counts[s] - done);
      chunks.push_back({s, first, count, share});
      first += count;
    }
  }
  return chunks;
}

// Fills the chunk's points of the cloud; writes nowhere else.
void sample_chunk(const Scene& scene, const Chunk& chunk, const SynthesisOptions& options,
                  const std::vector<std::uint32_t>& occluders, const Vector3d& shift,
                  PointCloud& cloud) {
  const Surface& surface = scene.surfaces()[chunk.surface];
  Random random(options.random_seed, {kSampling, chunk.surface, chunk.first});
  EvenSequence sequence(random, static_cast<double>(chunk.count) / chunk.free_share);
  for (std::uint64_t i = chunk.first; i < chunk.first + chunk.count;) {
    const Vector2d uv = sequence.next();
    const SurfacePoint point = surface.geometry.sample(uv.x(), uv.y());
    if (scene.hidden(point, occluders)) continue;
    const Vector3d noisy = point.position + options.noise * random.normal() * point.normal;
    cloud.positions[i] = (noisy + shift).cast<float>();
    cloud.colors[i] = shade(surface.material, point.texture, random);
    cloud.labels[i] = surface.label;
    if (options.normals) cloud.normals[i] = point.normal.cast<float>();
    ++i;
  }
}

}  // namespace

std::vector<std::uint64_t> apportion(std::uint64_t total, std::span<const double> weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<std::uint64_t> shares(weights.size());
  std::vector<double> remainders(weights.size());
  std::uint64_t given = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double exact = static_cast<double>(total) * (weights[i] / sum);
    shares[i] = std::min(static_cast<std::uint64_t>(exact), total - given);
    remainders[i] = weights[i] > 0 ? exact - static_cast<double>(shares[i]) : -1.0;
    given += shares[i];
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainders[a] > remainders[b]; });
  const auto entitled = static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0; }));
  for (std::size_t i = 0; given < total; ++i, ++given) ++shares[order[i % entitled]];
  return shares;
}

TruePlane describe_plane(const Surface& surface, const VisiblePart& shown, const Isometry3d& pose) {
  TruePlane plane;
  const Vector3d normal = pose.linear() * surface.geometry.normal();
  plane.plane.normal = normal.cast<float>();
  plane.plane.distance = static_cast<float>(normal.dot(pose * surface.geometry.pose.translation()));
  plane.label = surface.label;
  plane.area = shown.area;
  plane.centroid = (pose * shown.centroid).cast<float>();
  plane.name = surface.name;
  plane.structural = surface.structural;
  return plane;
}

SynthesizedScene sample_evenly(const Scene& scene, const SynthesisOptions& options,
                               const Vector3d& shift) {
  const Occluders occluders = scene.find_occluders();
  const std::vector<VisiblePart> parts = find_visible_parts(scene, occluders);
  const std::vector<Chunk> chunks = divide_points(scene, parts, options.points);
  SynthesizedScene made;
  made.objects = scene.objects();
  PointCloud& cloud = made.cloud;
  cloud.positions.resize(options.points);
  cloud.colors.resize(options.points);
  cloud.labels.resize(options.points);
  if (options.normals) cloud.normals.resize(options.points);
  cloud.width = static_cast<std::uint32_t>(options.points);
  tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t k) {
    sample_chunk(scene, chunks[k], options, occluders[chunks[k].surface], shift, cloud);
  });
  const Isometry3d moved(Eigen::Translation3d(shift.x(), shift.y(), shift.z()));
  for (std::size_t s = 0; s < parts.size(); ++s) {
    const Surface& surface = scene.surfaces()[s];
    if (surface.geometry.planar() && parts[s].area > 0) {
      made.planes.push_back(describe_plane(surface, parts[s], moved));
    }
  }
  return made;
}

}  // namespace planescope::synthesis
