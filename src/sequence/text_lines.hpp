// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_cursor.hpp"
#include "io/input_file.hpp"

namespace planescope::sequence {

/// The lines of a small text file as words; blank lines and those that start with # do not count.
class TextLines {
 public:
  /// \throws Error{Kind::Input} missing, empty, or no regular file.
  TextLines(const std::filesystem::path& file, const std::string& expected);

  /// The next line's words into words(); false at the end of the file.
  bool next();

  const std::vector<std::string_view>& words() const noexcept { return words_; }
  std::uint64_t line() const noexcept { return line_; }

  /// The word as a number, which may be nan or inf.
  /// \throws Error{Kind::Input} with the line: there is no such word, or it is no number.
  double number(std::size_t word) const;

  /// \throws Error{Kind::Input} the line has another number of words; `expected` says what is.
  void require(std::size_t words, const char* expected) const;

  [[noreturn]] void fail(const std::string& what) const { file_.fail_line(line_, what); }
  const io::InputFile& file() const noexcept { return file_; }

 private:
  io::InputFile file_;
  io::ByteCursor cursor_;
  std::uint64_t line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace planescope::sequence
