// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <future>

#include "planescope/fusion.hpp"

namespace planescope {

TsdfVolume fuse(const Sequence& sequence, const FusionOptions& options, const Progress& progress) {
  TsdfVolume volume(options);
  const auto read = [&](std::size_t i) {
    return std::async(std::launch::async, [&sequence, i] { return sequence.read(i); });
  };
  std::future<Frame> next = read(0);  // a sequence has a frame
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (progress) progress("fusion", double(i) / double(sequence.size()));
    const Frame frame = next.get();
    if (i + 1 < sequence.size()) next = read(i + 1);
    volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
  }
  if (progress) progress("fusion", 1);
  return volume;
}

}  // namespace planescope
