// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/run_info.hpp"

#include <sys/resource.h>

#include <array>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/console.hpp"

namespace planescope::cli {
namespace {

/// Nobody needs a time beyond a microsecond.
double rounded(double milliseconds) { return std::round(milliseconds * 1000) / 1000; }

/// ISO 8601, UTC.
std::string date() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::array<std::pair<const char*, double>, 10> times(const RunInfo& run) {
  const StageTimes& s = run.stages;
  return {{{"read", s.read},
           {"patches", s.patches},
           {"hypotheses", s.hypotheses},
           {"selection", s.selection},
           {"assignment", s.assignment},
           {"edges", s.edges},
           {"segments", s.segments},
           {"pictures", run.pictures},
           {"write", run.write},
           {"total", run.total}}};
}

}  // namespace

double Stopwatch::lap() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::milli> passed = now - start_;
  start_ = now;
  return passed.count();
}

double peak_memory_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

std::string RunInfo::json() const {
  nlohmann::ordered_json timings;
  for (const auto& [name, value] : times(*this)) timings[name] = rounded(value);
  const nlohmann::ordered_json all = {{"planescope", PLANESCOPE_VERSION},
                                      {"timings_ms", timings},
                                      {"peak_memory_mb", std::round(peak_memory_mb() * 10) / 10},
                                      {"threads", threads},
                                      {"uncertain_points", uncertain},
                                      {"odometry", odometry},
                                      {"date", date()}};
  return all.dump(1) + "\n";
}

std::string RunInfo::brief() const {
  std::string text;
  for (const auto& [name, value] : times(*this)) {
    text += (text.empty() ? "" : ", ") + std::string(name) + " " + duration(value);
  }
  return text;
}

}  // namespace planescope::cli
