// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <tbb/parallel_for.h>

#include "planes/seeds.hpp"

namespace planescope {
namespace {

/// A plane of lambda inliers keeps this many of them in the sample on average; were they drawn
/// independently, one such plane in 4,000 would keep fewer than 10.
constexpr double kSampleSupport = 24;
constexpr double kSmallestSample = 8192;
constexpr double kPatchTests = 6e7;  // bounds the fits on the sample to about 0.3 s of one core
constexpr double kFewestFits = 512;

bool near_duplicate(const Hypothesis& large, const Hypothesis& small) {
  constexpr float kSameCosine = 0.9962f;  // 5 degrees
  constexpr double kSameInliers = 0.8;
  if (std::abs(large.plane.normal.dot(small.plane.normal)) < kSameCosine) return false;
  if (small.support < kSameInliers * large.support) return false;
  return count_common(large.inliers, small.inliers) >= kSameInliers * large.support;
}

std::size_t sample_size(std::size_t patches, double lambda) {
  const double wanted = std::ceil(kSampleSupport * static_cast<double>(patches) / lambda);
  return static_cast<std::size_t>(
      std::min(static_cast<double>(patches), std::max(wanted, kSmallestSample)));
}

/// Fewest inliers in the sample that a plane of more than lambda inliers may have, four standard
/// deviations below the mean; with a whole sample the slack is for what the last refit gains.
double least_support(double expected) { return expected - 4 * std::sqrt(expected); }

std::vector<Hypothesis> search_sample(const PatchIndex& sample, const PlaneOptions& options,
                                      double least, std::uint32_t& proposed) {
  const PlaneSearch search(sample, options);
  std::vector<Seed> seeds = patch_seeds(sample, options.max_curvature);
  const std::vector<Seed> triples =
      triple_seeds(sample, options, static_cast<float>(40 * options.sigma));
  proposed = static_cast<std::uint32_t>(seeds.size() + triples.size());
  const double most = std::max(kFewestFits, kPatchTests / static_cast<double>(sample.size() + 1));
  std::vector<Hypothesis> found =
      search.fit_uncovered(std::move(seeds), static_cast<std::size_t>(most), least);
  std::vector<Hypothesis> more = search.fit_each(triples, found, least);
  std::move(more.begin(), more.end(), std::back_inserter(found));
  return merge_duplicates(std::move(found));
}

/// Refits all to all patches; what D refuses and what is there twice is left out.
std::vector<Hypothesis> settle(const PatchIndex& index, const PlaneOptions& options, double lambda,
                               std::vector<Hypothesis> found) {
  constexpr int kSteps = 8;  // most settle earlier
  const PlaneSearch search(index, options);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    const bool held = found[i].held;
    found[i] = search.refit(found[i].plane, kSteps);
    found[i].held = held;
  });
  std::erase_if(found, [&](const Hypothesis& h) { return h.support <= lambda; });
  return merge_duplicates(std::move(found));
}

}  // namespace

double support_threshold(const std::vector<Patch>& patches, double min_area) {
  constexpr double kFewest = 3;
  std::vector<float> areas;
  double total = 0;
  for (const Patch& patch : patches) {
    if (!(patch.area > 0)) continue;
    areas.push_back(patch.area);
    total += static_cast<double>(patch.area);
  }
  std::sort(areas.begin(), areas.end());
  double below = 0;  // area of the patches up to the median
  for (const float area : areas) {
    below += static_cast<double>(area);
    if (below >= 0.5 * total) return std::max(kFewest, min_area / static_cast<double>(area));
  }
  return kFewest;
}

std::vector<Hypothesis> merge_duplicates(std::vector<Hypothesis> hypotheses) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const auto& a, const auto& b) { return a.support > b.support; });
  std::vector<Hypothesis> kept;
  for (Hypothesis& h : hypotheses) {
    const auto same = [&](const Hypothesis& k) { return near_duplicate(k, h); };
    const auto found = std::find_if(kept.begin(), kept.end(), same);
    if (found == kept.end()) {
      kept.push_back(std::move(h));
    } else {
      found->held = found->held || h.held;
    }
  }
  return kept;
}

Hypotheses propose_hypotheses(const PatchIndex& index, const PlaneOptions& options, double lambda) {
  Hypotheses result;
  if (index.size() == 0) return result;
  const PatchIndex sample = index.sample(sample_size(index.size(), lambda), options.random_seed);
  const double rate = static_cast<double>(sample.size()) / static_cast<double>(index.size());
  std::vector<Hypothesis> found =
      search_sample(sample, options, least_support(lambda * rate), result.proposed);
  if (found.size() > options.max_hypotheses) found.resize(options.max_hypotheses);
  result.kept = settle(index, options, lambda, std::move(found));
  return result;
}

Hypotheses renew_hypotheses(const PatchIndex& index, const PlaneOptions& options, double lambda,
                            const std::vector<HeldPlane>& held,
                            const std::vector<std::uint8_t>& fresh) {
  Hypotheses result;
  if (index.size() == 0) return result;
  std::vector<Hypothesis> found;
  found.reserve(held.size());
  for (const HeldPlane& h : held) {
    found.push_back({.plane = h.plane, .support = 0, .inliers = {}, .held = h.selected});
  }
  found = settle(index, options, lambda, std::move(found));
  std::vector<Seed> seeds = patch_seeds(index, options.max_curvature);
  std::erase_if(seeds, [&](const Seed& s) { return fresh[index.patch(s.position)] == 0; });
  const PlaneSearch search(index, options);
  search.drop_covered(seeds, found);
  result.proposed = static_cast<std::uint32_t>(seeds.size());
  const double most = std::max(kFewestFits, kPatchTests / static_cast<double>(index.size() + 1));
  std::vector<Hypothesis> more =
      search.fit_uncovered(std::move(seeds), static_cast<std::size_t>(most), lambda);
  if (!more.empty()) {
    more = settle(index, options, lambda, std::move(more));
    std::move(more.begin(), more.end(), std::back_inserter(found));
    found = merge_duplicates(std::move(found));
  }
  if (found.size() > options.max_hypotheses) found.resize(options.max_hypotheses);
  result.kept = std::move(found);
  return result;
}

}  // namespace planescope
