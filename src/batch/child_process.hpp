// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/ending.hpp"

/// \file A program that runs beside this one and cannot take it down.
namespace planescope {

/// What a child may take; 0: no limit.
struct ChildLimits {
  double seconds = 0;           ///< [s] wall clock; then it is killed
  std::uint64_t memory_mb = 0;  ///< [MB] of its own data (RLIMIT_DATA); more is refused to it
};

/// How a child ended.
struct ChildEnd {
  enum class How { Exited, Signalled, TimedOut } how = How::Exited;
  int code = 0;               ///< exit code, or signal
  double seconds = 0;         ///< [s] wall clock
  double peak_memory_mb = 0;  ///< [MB] largest resident size

  bool good() const { return how == How::Exited && code == 0; }
};

/// Starts a program at construction; the destructor kills it if it still runs. It dies with this
/// process too, however that ends, and so do its own children if it is killed here.
class ChildProcess {
 public:
  /// \param words the program (looked up in PATH where it has no slash) and its arguments;
  /// \param out,err files for what it prints; stdin is empty.
  /// \throws Error{Kind::Computation} the system starts no more processes;
  /// Error{Kind::Input} the files cannot be written.
  ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& out,
               const std::filesystem::path& err, const ChildLimits& limits);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// How it ended, or nothing while it runs. Kills it where its time is over.
  std::optional<ChildEnd> poll();

 private:
  void start(const std::vector<std::string>& words, const std::filesystem::path& out,
             const std::filesystem::path& err);
  void ask_to_end() const;
  void reap(int status, double peak_memory_mb);

  pid_t pid_ = -1;
  std::chrono::steady_clock::time_point start_;
  ChildLimits limits_;
  bool timed_out_ = false;
  std::optional<ChildEnd> end_;
  EndingAction undo_;
};

}  // namespace planescope
