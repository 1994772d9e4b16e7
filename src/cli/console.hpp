// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planescope/options.hpp"

namespace CLI {
class App;
}

namespace planescope::cli {

/// What is said, and where: messages for people on stderr, what was asked for on stdout.
struct Console {
  bool quiet = false;    ///< -q: nothing on stderr but errors
  bool verbose = false;  ///< -v: timings and every option
  bool json = false;     ///< --json: the outcome as JSON on stdout

  /// Adds -q, -v and --json to a subcommand.
  void declare(CLI::App& command);

  void say(const std::string& line) const;     ///< unless -q
  void detail(const std::string& line) const;  ///< with -v

  /// A progress bar where stderr is a terminal and -q was not given; else nothing.
  Progress progress() const;
};

/// One line that no terminal takes for a command: control characters, which names of files may
/// hold, become blanks.
std::string printable(std::string text);

/// `12.3 s`, `45 ms`: a duration for people.
std::string duration(double milliseconds);

}  // namespace planescope::cli
