// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string_view>

#include "io/ending.hpp"

namespace planescope::io {

/// A file written from front to back in large pieces, that appears whole or not at all: it has no
/// name before commit() where the file system can do that (O_TMPFILE: a process that is killed
/// leaves nothing), and a temporary, hidden one elsewhere. What was there under the name is
/// replaced; a link is replaced, not followed.
class OutputFile {
 public:
  /// \throws Error{Kind::Input} the folder is missing or cannot be written to.
  explicit OutputFile(const std::filesystem::path& target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// \throws Error{Kind::Input} the disk is full or fails.
  void write(std::string_view bytes);

  /// Closes the file and puts it in place. \throws Error{Kind::Input} either fails.
  void commit();

 private:
  void open();
  void remove_temporary() const;
  [[noreturn]] void fail(int why) const;

  std::filesystem::path target_, temporary_;  ///< in the same folder
  EndingAction undo_;
  int descriptor_ = -1;
  bool named_ = false;  ///< temporary_ is there
};

}  // namespace planescope::io
