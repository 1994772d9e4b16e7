// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/memory.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>

#include "batch/data_limit.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

[[noreturn]] void terminate() {
  const char* line =
      "planescope: internal error: something ended at the wrong place; please "
      "report it\n";
  auto kind = Error::Kind::Internal;
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    line =
        "planescope: out of memory; give it more, or take larger voxels, or fewer points or "
        "frames\n";
    kind = Error::Kind::Computation;
  } catch (...) {
  }
  std::fputs(line, stderr);
  ::_exit(static_cast<int>(kind));
}

}  // namespace

void LimitArguments::declare(CLI::App& command) {
  command.add_option("--max-points", read_.max_points, "Refuse clouds of more points")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command
      .add_option("--max-memory", memory_mb_,
                  "End with exit code 4 rather than take more than this [MB] (no limit)")
      ->check(CLI::Range(16, 1 << 30))
      ->type_name("MB");
}

void LimitArguments::apply() const {
  if (memory_mb_ == 0) return;
  limit_data(memory_mb_ << 20, false);
}

void require_memory_for_drawing(const RenderOptions& picture) {
  // Measured with Mesa 22.3 and LLVM 15: 430 MB and 47 bytes for every pixel that is drawn.
  const auto samples = std::uint64_t(picture.supersample) * std::uint64_t(picture.supersample);
  const std::uint64_t pixels =
      std::uint64_t(picture.size[0]) * std::uint64_t(picture.size[1]) * samples;
  const std::uint64_t bytes = (std::uint64_t{500} << 20) + 56 * pixels;
  void* room = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) {
    throw Error(Error::Kind::Computation,
                "out of memory: drawing takes up to " + std::to_string(bytes >> 20) +
                    " MB, and the process may not have them; raise its limit (ulimit -v, "
                    "--max-memory), or take a smaller --size or no pictures");
  }
  ::munmap(room, bytes);
}

void explain_termination() { std::set_terminate(&terminate); }

}  // namespace planescope::cli
