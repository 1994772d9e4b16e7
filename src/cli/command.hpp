// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace CLI {
class App;
}

/// \file The subcommands. One file each: declarations (CLI11) and calls into the library. A new
/// subcommand is a new file, a line here and a line in program.cpp.
namespace planescope::cli {

/// A declared subcommand: run() is called once, after the command line was parsed and only if it
/// names this one.
struct Command {
  CLI::App* app = nullptr;
  std::function<void()> run;
};

Command add_segment(CLI::App& program);
Command add_render(CLI::App& program);
Command add_evaluate(CLI::App& program);
Command add_figure(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_batch(CLI::App& program);
Command add_reconstruct(CLI::App& program);
Command add_synthesize(CLI::App& program);
Command add_track(CLI::App& program);

/// Runs the program. \returns the exit code; what goes wrong below is thrown.
int run_program(int argc, char** argv);

}  // namespace planescope::cli
