// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.hpp"
#include "io/pcd_reader.hpp"

namespace planescope::fuzzing {

void fuzz(std::string_view bytes) {
  if (bytes.empty()) return;  // an empty file is refused where it is opened
  refused_or_taken([&] {
    const io::InputFile file("fuzz", std::as_bytes(std::span(bytes)));
    io::read_pcd(file, {.max_points = 1'000'000}, {"plane", "patch"});
  });
}

}  // namespace planescope::fuzzing
