// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "batch/child_process.hpp"
#include "batch/job.hpp"

/// \file Many scenes, each method on each of them a process of its own.
namespace planescope {

/// How a batch is run; what is run is its plan.
struct BatchRun {
  std::filesystem::path folder;      ///< of all results; made where it is missing
  std::vector<std::string> program;  ///< planescope, as a command
  ChildLimits limits;                ///< of a scene's process
  std::uint32_t jobs = 1;            ///< processes at a time
  bool pictures = false;
  bool fresh = false;  ///< do again what is done
  Shard shard;
};

/// What happened so far.
struct BatchState {
  std::size_t jobs = 0;              ///< of this shard
  std::size_t skipped = 0;           ///< done before, unchanged
  std::size_t done = 0, failed = 0;  ///< now
  double seconds = 0;                ///< [s] since the first one started

  std::size_t ended() const { return skipped + done + failed; }
  /// [s] what is left, at the pace so far; 0 before the first has ended.
  double seconds_left() const;
};

/// Called whenever a job has ended, and every now and then; `failure` tells which one failed and
/// why, and is empty otherwise.
using BatchProgress = std::function<void(const BatchState& state, const std::string& failure)>;

/// Runs `segment`, then `evaluate`, for every scene of the shard and every method. A job that is
/// done, on the same input, with the same settings and version, is skipped; one that failed is
/// tried again. Whatever befalls a job ends that job alone: its job.json says why. Killed at any
/// moment, the next run starts the unfinished jobs anew.
/// \throws Error{Kind::Input} the folder cannot be written.
BatchState run_batch(const BatchPlan& plan, const BatchRun& run, const BatchProgress& progress);

}  // namespace planescope
