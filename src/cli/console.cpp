// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/console.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>

namespace planescope::cli {
namespace {

/// Redraws one line of stderr, at most 20 times a second, and wipes it at the end.
class Bar {
 public:
  ~Bar() { wipe(); }

  void show(std::string_view stage, double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (shown_ && stage == stage_ && now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    stage_ = stage;
    shown_ = true;
    constexpr int kWidth = 30;
    const int done = static_cast<int>(fraction * kWidth);
    std::fprintf(stderr, "\r\033[K%-12s [%-*s] %3.0f %%", stage_.c_str(), kWidth,
                 std::string(static_cast<std::size_t>(done), '#').c_str(), 100 * fraction);
    std::fflush(stderr);
  }

 private:
  void wipe() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

  std::string stage_;
  std::chrono::steady_clock::time_point last_;
  bool shown_ = false;
};

}  // namespace

void Console::declare(CLI::App& command) {
  auto* silent = command.add_flag("-q,--quiet", quiet, "Say nothing but errors");
  command.add_flag("-v,--verbose", verbose, "Say more: timings, options")->excludes(silent);
  command.add_flag("--json", json, "Print the outcome as JSON on stdout");
}

void Console::say(const std::string& line) const {
  if (!quiet) std::fprintf(stderr, "%s\n", printable(line).c_str());
}

void Console::detail(const std::string& line) const {
  if (verbose) std::fprintf(stderr, "%s\n", printable(line).c_str());
}

Progress Console::progress() const {
  if (quiet || ::isatty(STDERR_FILENO) == 0) return {};
  return [bar = std::make_shared<Bar>()](std::string_view stage, double fraction) {
    bar->show(stage, fraction);
  };
}

std::string printable(std::string text) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
  std::ranges::replace_if(text, is_control, ' ');
  return text;
}

std::string duration(double milliseconds) {
  char text[32];
  const bool long_time = milliseconds >= 1000;
  std::snprintf(text, sizeof text, long_time ? "%.1f s" : "%.0f ms",
                long_time ? milliseconds / 1000 : milliseconds);
  return text;
}

}  // namespace planescope::cli
