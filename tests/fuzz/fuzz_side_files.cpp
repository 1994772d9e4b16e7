// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch/job.hpp"
#include "batch/scene_list.hpp"
#include "batch/table.hpp"
#include "fuzz_target.hpp"
#include "planescope/camera.hpp"
#include "planescope/synthesize.hpp"

/// \file The small files that people edit: the first byte says which one the others are.
namespace planescope::fuzzing {
namespace {

void read_as(char kind, const ScratchFolder& folder, std::string_view bytes) {
  switch (kind) {
    case 'b':
      folder.write("batch.json", bytes);
      summarise(folder.path());
      return;
    case 'j':
      folder.write("job.json", bytes);
      read_record(folder.path());
      return;
    case 'm':
      read_measures(folder.write("a.json", bytes), folder.write("b.json", bytes));
      return;
    case 'l':
      read_scenes({folder.write("list.txt", bytes).string()});
      return;
    case 't':
      read_true_planes(folder.write("truth.json", bytes));
      return;
    default:
      parse_camera(std::string(bytes), "camera.json");
  }
}

}  // namespace

void fuzz(std::string_view bytes) {
  static const ScratchFolder folder;
  if (bytes.empty()) return;
  refused_or_taken([&] { read_as(bytes.front(), folder, bytes.substr(1)); });
}

}  // namespace planescope::fuzzing
