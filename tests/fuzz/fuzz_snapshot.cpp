// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>
#include <string>

#include "fuzz_target.hpp"
#include "planescope/fusion.hpp"
#include "planescope/track.hpp"

/// \file The two parts of a snapshot of `track` that the library reads: after the byte `v` a fused
/// volume, after any other a tracker. In libFuzzer's builds the sections' hashes are not checked
/// (io/state_stream.cpp), so that mutations come past them.
namespace planescope::fuzzing {

void fuzz(std::string_view bytes) {
  if (bytes.empty()) return;
  std::istringstream from{std::string(bytes.substr(1))};
  refused_or_taken([&] {
    if (bytes.front() == 'v') {
      const TsdfVolume volume = TsdfVolume::read(from, "snapshot");
      for (const BlockKey& block : volume.changed_since(0)) volume.block_points(block);
    } else {
      MapTracker::read(from, "snapshot");
    }
  });
}

}  // namespace planescope::fuzzing
