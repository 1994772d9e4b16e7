// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "batch/measures.hpp"
#include "batch/scene_list.hpp"

/// \file The plan of a batch and the state of its jobs, as files: what makes it resumable.
namespace planescope {

/// What a batch is to do; batch.json in its folder.
struct BatchPlan {
  std::vector<BatchScene> scenes;
  std::vector<std::string> methods;
  std::vector<std::string> segment_arguments;   ///< for `planescope segment`, beyond the scene's
  std::vector<std::string> evaluate_arguments;  ///< for `planescope evaluate`
  bool scored = true;                           ///< the scenes have truth

  /// Tells apart jobs of other versions, methods or arguments, and of other configuration files.
  /// \throws Error{Kind::Input} the configuration file cannot be read.
  std::string settings_key(const std::string& method) const;
};

/// Writes batch.json, whole; the same for every shard.
void write_plan(const BatchPlan& plan, const std::filesystem::path& folder);

/// A job as the table needs it.
struct PlannedJob {
  std::string scene, method, settings_key;
};

/// All jobs of a stored plan, scene by scene, and its methods.
struct StoredPlan {
  std::vector<std::string> scenes, methods;
  std::vector<PlannedJob> jobs;
};

/// \throws Error{Kind::Input} the folder has no batch.json, or a malformed one.
StoredPlan read_plan(const std::filesystem::path& folder);

/// How a job ended; job.json in its folder.
struct JobRecord {
  std::string settings_key;  ///< BatchPlan::settings_key()
  std::string input_key;     ///< hash of the scene's and the truth's bytes
  bool done = false;
  std::string reason;  ///< why not, in one line
  double peak_memory_mb = 0;
  MeasureValues values;
};

/// Whether a scene or method may name a folder: one word that is neither hidden nor leads
/// elsewhere.
bool is_folder_name(const std::string& name);

/// `folder`/`scene`/`method`.
std::filesystem::path job_folder(const std::filesystem::path& folder, const std::string& scene,
                                 const std::string& method);

/// Writes job.json, whole; it is the last that a job writes.
void write_record(const JobRecord& record, const std::filesystem::path& job_folder);

/// Nothing where there is no job.json, or one that this version does not understand.
std::optional<JobRecord> read_record(const std::filesystem::path& job_folder);

/// Hash of what a scene reads. Files that are missing, or no regular ones (a pipe would block), are
/// told by that.
std::string input_key(const BatchScene& scene);

}  // namespace planescope
