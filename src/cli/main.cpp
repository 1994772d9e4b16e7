// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/memory.hpp"
#include "cli/signals.hpp"
#include "freed_memory.hpp"
#include "planescope/error.hpp"

namespace {

constexpr const char* kNoThread =
    "out of memory for a thread; give it more, or take fewer --threads";

/// One line on stderr, whatever the message holds.
int fail(const std::string& message, planescope::Error::Kind kind) {
  std::fprintf(stderr, "planescope: %s\n", planescope::cli::printable(message).c_str());
  return static_cast<int>(kind);
}

}  // namespace

int main(int argc, char** argv) {
  using Kind = planescope::Error::Kind;
  planescope::cli::handle_signals();
  planescope::cli::explain_termination();
  planescope::keep_freed_memory();
  try {
    const int code = planescope::cli::run_program(argc, argv);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    return fail("stdout: what was asked for could not be written; is it closed, or the disk full?",
                Kind::Input);
  } catch (const planescope::Error& error) {
    return fail(error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; give it more, or take larger voxels, or fewer points or frames",
                Kind::Computation);
  } catch (const std::system_error& error) {
    const bool starved = error.code() == std::errc::resource_unavailable_try_again ||
                         error.code() == std::errc::not_enough_memory;
    if (starved) return fail(kNoThread, Kind::Computation);
    // files: std::filesystem, streams
    return fail(std::string(error.what()) + "; is it a file that can be read and written?",
                Kind::Input);
  } catch (const std::exception& error) {
    // oneTBB's words, in a std::runtime_error.
    if (std::string_view(error.what()).starts_with("pthread_create has failed"))
      return fail(kNoThread, Kind::Computation);
    return fail(std::string("internal error: ") + error.what() + "; please report it",
                Kind::Internal);
  }
}
