// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string_view>

namespace planescope {

/// A file that appears whole or not at all: write to temporary(), then commit(), which renames it
/// into place. Without commit() the temporary is removed.
class WholeFile {
 public:
  /// \throws Error{Kind::Input} the folder of `target` does not exist.
  explicit WholeFile(std::filesystem::path target);
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  /// In the same folder, with the same extension (writers that choose a format by it work), unique
  /// to this process.
  const std::filesystem::path& temporary() const noexcept { return temporary_; }

  /// \throws Error{Kind::Input} the temporary is not there or cannot be renamed.
  void commit();

 private:
  std::filesystem::path target_, temporary_;
};

/// Writes bytes as a whole file. \throws Error{Kind::Input} the folder is missing, read-only, or
/// the disk is full.
void write_whole(const std::filesystem::path& target, std::string_view bytes);

}  // namespace planescope
