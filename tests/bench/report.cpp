// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include <cstdio>

namespace planescope::bench {

void MedianReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    const bool single = run.run_type == Run::RT_Iteration && run.repetitions == 1;
    const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
    if (run.error_occurred || (!single && !median)) continue;
    medians[run.run_name.function_name] =
        run.GetAdjustedRealTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
    for (const auto& [name, counter] : run.counters)
      medians[run.run_name.function_name + ":" + name] = counter.value;
  }
  ConsoleReporter::ReportRuns(runs);
}

void print_ratios(const std::vector<Ratio>& ratios, const std::map<std::string, double>& medians) {
  std::printf("\n%-66s %9s %10s\n", "ratio of medians", "measured", "promised");
  for (const Ratio& ratio : ratios) {
    const auto top = medians.find(ratio.numerator);
    const auto bottom = medians.find(ratio.denominator);
    const bool known =
        top != medians.end() && (ratio.denominator.empty() || bottom != medians.end());
    const char* sign = ratio.at_least ? ">=" : "<=";
    if (!known) {
      std::printf("%-66s %9s %s %7.2f\n", ratio.what.c_str(), "not run", sign, ratio.target);
      continue;
    }
    const double value = top->second / (ratio.denominator.empty() ? 1.0 : bottom->second);
    const bool met = ratio.at_least ? value >= ratio.target : value <= ratio.target;
    std::printf("%-66s %9.2f %s %7.2f  %s\n", ratio.what.c_str(), value, sign, ratio.target,
                met ? "met" : "MISSED");
  }
}

}  // namespace planescope::bench
