// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

/// \file The one error type of planescope: thrown in the library, caught once in main().
namespace planescope {

/// What went wrong, in one line: what, where (file, line or byte), what was expected, what to do.
class Error : public std::runtime_error {
 public:
  /// The values are the program's exit codes (README, "Exit codes").
  enum class Kind {
    Internal = 1,     ///< a promise of planescope itself was broken
    Usage = 2,        ///< an option or argument is wrong
    Input = 3,        ///< a file is missing, malformed, truncated or empty
    Computation = 4,  ///< a stage cannot answer (memory, degenerate scene, time)
    Rendering = 5,    ///< no OpenGL context, or an empty picture
    Mismatch = 6,     ///< compared or batched, and found wanting
  };

  /// Control characters, which names and words from files may hold, become blanks.
  Error(Kind kind, const std::string& message)
      : std::runtime_error(one_line(message)), kind_(kind) {}

  Kind kind() const noexcept { return kind_; }
  int exit_code() const noexcept { return static_cast<int>(kind_); }

 private:
  static std::string one_line(std::string text) {
    for (char& c : text)
      if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
    return text;
  }

  Kind kind_;
};

}  // namespace planescope
