// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cli/command.hpp"
#include "planescope/error.hpp"

namespace {

/// One line on stderr, whatever the message holds (file names may hold newlines).
int fail(std::string message, planescope::Error::Kind kind) {
  std::ranges::replace(message, '\n', ' ');
  std::fprintf(stderr, "planescope: %s\n", message.c_str());
  return static_cast<int>(kind);
}

}  // namespace

int main(int argc, char** argv) {
  using Kind = planescope::Error::Kind;
  try {
    return planescope::cli::run_program(argc, argv);
  } catch (const planescope::Error& error) {
    return fail(error.what(), error.kind());
  } catch (const std::bad_alloc&) {
    return fail("out of memory; give it more, or take a larger --voxel-size or fewer points",
                Kind::Computation);
  } catch (const std::exception& error) {
    return fail(std::string("internal error: ") + error.what() + "; please report it",
                Kind::Internal);
  }
}
