// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.hpp"
#include "planescope/result.hpp"

/// \file A result folder: result.json up to the first zero byte, points.pcd after it. Where the
/// JSON has @HASH@, the hash of those points is put: fuzzing does not guess hashes.
namespace planescope::fuzzing {

void fuzz(std::string_view bytes) {
  static const ScratchFolder folder;
  const std::size_t split = std::min(bytes.find('\0'), bytes.size());
  std::string json(bytes.substr(0, split));
  const auto points = folder.write("points.pcd", bytes.substr(std::min(split + 1, bytes.size())));
  constexpr std::string_view kHash = "@HASH@";
  if (const auto at = json.find(kHash); at != std::string::npos)
    json.replace(at, kHash.size(), hash_file(points));
  folder.write("result.json", json);
  refused_or_taken([] { load_result(folder.path()); });
}

}  // namespace planescope::fuzzing
