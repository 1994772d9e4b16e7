// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "planescope/pipeline.hpp"

namespace planescope::cli {

/// Milliseconds since construction or the last lap().
class Stopwatch {
 public:
  double lap();

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What differs from run to run: run.json.
struct RunInfo {
  StageTimes stages;                          ///< [ms]
  double pictures = 0, write = 0, total = 0;  ///< [ms]
  std::size_t threads = 0;
  std::size_t uncertain = 0;  ///< points left out by --min-confidence
  bool odometry = false;      ///< the sequence's poses were estimated

  /// run.json's text, with peak memory and date as they are now.
  std::string json() const;

  /// `read 12 ms, patches 1.2 s, ...`
  std::string brief() const;
};

/// Largest resident size of this process so far [MB].
double peak_memory_mb();

}  // namespace planescope::cli
