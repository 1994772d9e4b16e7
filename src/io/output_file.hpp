// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string_view>

#include "io/whole_file.hpp"

namespace planescope::io {

/// A file written from front to back in large pieces, that appears whole or not at all.
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
  [[noreturn]] void fail() const;

  std::filesystem::path target_;
  WholeFile whole_;
  int descriptor_;
};

}  // namespace planescope::io
