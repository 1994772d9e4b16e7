// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "planescope/io.hpp"
#include "planescope/render.hpp"

namespace CLI {
class App;
}

/// \file Limits of what is read and taken, and what is said where memory is short.
namespace planescope::cli {

/// --max-points and --max-memory: what every subcommand that reads clouds takes.
class LimitArguments {
 public:
  void declare(CLI::App& command);
  /// Limits this process's memory from now on; what exceeds it ends with exit code 4.
  void apply() const;
  const ReadLimits& read() const { return read_; }

 private:
  ReadLimits read_;
  std::uint64_t memory_mb_ = 0;
};

/// OpenGL's libraries end the process where they get no memory, so it is asked for before they are.
/// \throws Error{Kind::Computation} there is less than such a picture takes.
void require_memory_for_drawing(const RenderOptions& picture);

/// From now on an exception that nothing catches ends the process with one line and our exit code,
/// not by a signal: memory may run out where nothing may be thrown.
void explain_termination();

}  // namespace planescope::cli
