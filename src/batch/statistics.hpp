// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

/// \file What a sample of scenes says about a method.
namespace planescope {

/// How values become one.
enum class Statistic { Mean, Median };

/// A statistic of a sample, with its bootstrap 95 % interval.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;  ///< 2.5th and 97.5th percentile over the resamples
  std::size_t count = 0;     ///< values in the sample
};

/// Mean, or median (of an even number: the mean of the middle two), of one value or more.
double statistic(std::vector<double> values, Statistic kind);

/// The p-th percentile, 0 to 100, with linear interpolation between order statistics.
double percentile(std::vector<double> values, double p);

/// Percentile bootstrap (Efron and Tibshirani 1993, chapter 13): `resamples` draws of as many
/// values with replacement, seeded, the same on every machine. One value has no spread: its
/// interval is the value. \param values at least one.
Estimate bootstrap(const std::vector<double>& values, Statistic kind,
                   std::uint32_t resamples = 10'000, std::uint64_t random_seed = 1);

}  // namespace planescope
