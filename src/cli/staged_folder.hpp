// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/ending.hpp"

namespace planescope::cli {

/// \throws Error{Kind::Input} nothing can be written to a folder of this name: it is a file, or the
/// place is read-only. Asked before a long computation.
void check_writable(const std::filesystem::path& folder);

/// \throws Error{Kind::Usage} `input` is one of the files `names` in `folder`: the result would
/// take its place, and it would be lost.
void refuse_overwriting(const std::filesystem::path& input, const std::filesystem::path& folder,
                        const std::vector<std::string>& names);

/// A folder that is filled out of sight and then put in place, so that a failure half-way leaves
/// what was there before. What a killed process left of its own is removed on the way.
class StagedFolder {
 public:
  /// Stages beside (or, where it exists, inside) `target`: on the same file system.
  explicit StagedFolder(const std::filesystem::path& target);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  const std::filesystem::path& path() const { return staging_; }

  /// Moves every staged file into the target, each by a rename. `key` goes away first and comes
  /// back last: a folder that has it is complete. Files of `owned` that were not staged are
  /// removed: they are of an earlier run. Waits while another process publishes there: all files
  /// are of one run, the later one. \throws Error{Kind::Input} the target cannot be written.
  /// \returns the names of the files that are now in place, sorted.
  std::vector<std::string> publish(const std::string& key, const std::vector<std::string>& owned);

 private:
  bool stage(const std::filesystem::path& place);

  std::filesystem::path target_, staging_;
  int lock_ = -1;  ///< held on staging_: its owner lives
  EndingAction undo_;
};

}  // namespace planescope::cli
