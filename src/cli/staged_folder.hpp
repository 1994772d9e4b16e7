// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace planescope::cli {

/// \throws Error{Kind::Input} nothing can be written to a folder of this name: it is a file, or the
/// place is read-only. Asked before a long computation.
void check_writable(const std::filesystem::path& folder);

/// A folder that is filled out of sight and then put in place, so that a failure half-way leaves
/// what was there before.
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
  /// removed: they are of an earlier run. \throws Error{Kind::Input} the target cannot be written.
  /// \returns the names of the files that are now in place, sorted.
  std::vector<std::string> publish(const std::string& key, const std::vector<std::string>& owned);

 private:
  std::filesystem::path target_, staging_;
};

}  // namespace planescope::cli
