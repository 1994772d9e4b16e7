// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace planescope::bench {

/// Prints as Google Benchmark does and remembers each benchmark's median time and counters.
class MedianReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;

  std::map<std::string, double> medians;  ///< [s] by name; counters as `name:counter`
};

/// A promise about two medians.
struct Ratio {
  std::string what, numerator, denominator;  ///< names; an empty denominator is 1
  double target = 0;
  bool at_least = true;  ///< the ratio should be at least the target; else at most
};

/// Prints one line a promise: the ratio, the target, and whether it is met.
void print_ratios(const std::vector<Ratio>& ratios, const std::map<std::string, double>& medians);

}  // namespace planescope::bench
