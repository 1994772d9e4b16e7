// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/plane_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <tbb/parallel_for.h>

#include "planes/plane_fit.hpp"

namespace planescope {
namespace {

constexpr std::size_t kBatch = 32;  // seeds fitted at once; fixed, so that threads change nothing
constexpr float kSurfaceCosine = 0.94f;  // 20 degrees
constexpr float kCloseCosine = 0.985f;   // 10 degrees

void keep_supported(std::vector<Hypothesis>& kept, Hypothesis&& fit, double least_support) {
  if (fit.support > 0 && fit.support >= least_support) kept.push_back(std::move(fit));
}

}  // namespace

PlaneSearch::PlaneSearch(const PatchIndex& index, const PlaneOptions& options)
    : index_(index),
      sigma_(static_cast<float>(options.sigma)),
      gate_(static_cast<float>(options.normal_gate)),
      fit_gate_(gate_ > 0 ? std::max(gate_, kSurfaceCosine) : gate_) {}

Hypothesis PlaneSearch::refit(const Plane& plane, int steps) const {
  const auto members_of = [&](const Plane& p) {
    return index_.inliers({.plane = p, .half_width = sigma_, .gate = fit_gate_});
  };
  Hypothesis result{.plane = plane, .support = 0, .inliers = {}, .held = false};
  Bits members = members_of(plane);
  for (int step = 0; step < steps; ++step) {
    result.plane = fit_plane(index_, members, result.plane, sigma_);
    const Bits before = std::exchange(members, members_of(result.plane));
    if (members == before) break;
  }
  result.inliers = index_.inliers({.plane = result.plane, .half_width = sigma_, .gate = gate_});
  result.plane = orient_plane(index_, result.inliers, result.plane);
  const std::uint32_t all = count(result.inliers);
  result.support = 2 * count(members) < all ? 0 : all;
  return result;
}

PlaneSearch::Fit PlaneSearch::fit(const Seed& seed) const {
  constexpr int kSteps = 3;  // the survivors are refitted to all patches anyway
  const auto close = [&](const Plane& plane, float reach) {
    return index_.inliers({plane, sigma_ / 2, kCloseCosine, seed.center, reach});
  };
  Plane plane = seed.plane;
  Bits local;
  for (const float reach : {10 * sigma_, 40 * sigma_}) {
    const Bits near = index_.inliers({plane, sigma_, fit_gate_, seed.center, reach});
    plane = fit_plane(index_, near, plane, sigma_);
    if (local.empty()) local = close(plane, reach);
  }
  Fit result{.hypothesis = refit(plane, kSteps), .covered = {}};
  result.covered = close(result.hypothesis.plane, std::numeric_limits<float>::infinity());
  for (std::size_t w = 0; w < local.size(); ++w) result.covered[w] |= local[w];
  return result;
}

bool PlaneSearch::close(const Plane& plane, const Seed& seed) const {
  return std::abs(plane.signed_distance(seed.center)) < sigma_ / 2 &&
         std::abs(plane.normal.dot(seed.plane.normal)) >= kCloseCosine;
}

/// The next seeds, none of them a close inlier of another's plane. Seeds that have to wait stay in
/// `pending`; covered ones leave it.
std::vector<Seed> PlaneSearch::next_batch(std::vector<Seed>& pending, const Bits& covered,
                                          std::size_t most) const {
  std::vector<Seed> batch, rest;
  for (const Seed& seed : pending) {
    if (contains(covered, seed.position)) continue;
    const auto is_close = [&](const Seed& other) { return close(other.plane, seed); };
    const bool wait = batch.size() >= most || std::any_of(batch.begin(), batch.end(), is_close);
    (wait ? rest : batch).push_back(seed);
  }
  pending = std::move(rest);
  return batch;
}

std::vector<Hypothesis> PlaneSearch::fit_uncovered(std::vector<Seed> seeds, std::size_t most,
                                                   double least_support) const {
  std::vector<Hypothesis> kept;
  Bits covered(index_.words(), 0);
  for (std::size_t done = 0; done < most && !seeds.empty();) {
    const std::vector<Seed> batch = next_batch(seeds, covered, std::min(kBatch, most - done));
    std::vector<Fit> fits(batch.size());
    tbb::parallel_for(std::size_t{0}, batch.size(),
                      [&](std::size_t i) { fits[i] = fit(batch[i]); });
    for (Fit& fit : fits) {
      for (std::size_t w = 0; w < covered.size(); ++w) covered[w] |= fit.covered[w];
      keep_supported(kept, std::move(fit.hypothesis), least_support);
    }
    done += batch.size();
  }
  return kept;
}

void PlaneSearch::drop_covered(std::vector<Seed>& seeds,
                               const std::vector<Hypothesis>& known) const {
  Bits covered(index_.words(), 0);
  for (const Hypothesis& h : known) {
    const Bits near = index_.inliers({h.plane, sigma_ / 2, kCloseCosine});
    for (std::size_t w = 0; w < covered.size(); ++w) covered[w] |= near[w];
  }
  std::erase_if(seeds, [&](const Seed& seed) { return contains(covered, seed.position); });
}

std::vector<Hypothesis> PlaneSearch::fit_each(const std::vector<Seed>& seeds,
                                              const std::vector<Hypothesis>& known,
                                              double least_support) const {
  std::vector<Hypothesis> fits(seeds.size());
  tbb::parallel_for(std::size_t{0}, seeds.size(), [&](std::size_t i) {
    const auto is_close = [&](const Hypothesis& h) { return close(h.plane, seeds[i]); };
    if (std::none_of(known.begin(), known.end(), is_close)) fits[i] = fit(seeds[i]).hypothesis;
  });
  std::vector<Hypothesis> kept;
  for (Hypothesis& h : fits) keep_supported(kept, std::move(h), least_support);
  return kept;
}

}  // namespace planescope
