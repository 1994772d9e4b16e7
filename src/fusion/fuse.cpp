// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/fusion.hpp"
#include "sequence/read_ahead.hpp"

namespace planescope {

TsdfVolume fuse(const Sequence& sequence, const FusionOptions& options, const Progress& progress) {
  TsdfVolume volume(options);
  sequence::for_each_frame(sequence, "fusion", progress, [&](std::size_t, const Frame& frame) {
    volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
  });
  return volume;
}

}  // namespace planescope
