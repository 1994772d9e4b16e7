// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace planescope {

double percentile(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double at = p / 100 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - std::floor(at)) * (values[above] - values[below]);
}

double statistic(std::vector<double> values, Statistic kind) {
  if (kind == Statistic::Median) return percentile(std::move(values), 50);
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Estimate bootstrap(const std::vector<double>& values, Statistic kind, std::uint32_t resamples,
                   std::uint64_t random_seed) {
  std::mt19937_64 random(random_seed);
  std::vector<double> found(resamples), sample(values.size());
  for (double& one : found) {
    // The remainder is off uniform by less than 1e-15 for any number of scenes.
    for (double& value : sample) value = values[random() % values.size()];
    one = statistic(sample, kind);
  }
  return {statistic(values, kind), percentile(found, 2.5), percentile(found, 97.5), values.size()};
}

}  // namespace planescope
