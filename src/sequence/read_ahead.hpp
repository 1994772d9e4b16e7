// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <future>
#include <string_view>

#include "planescope/options.hpp"
#include "planescope/sequence.hpp"

namespace planescope::sequence {

/// Calls take(i, frame) for all frames in order, reading one while the last one is worked on;
/// reports `stage`. \throws Error as Sequence::read() and `take` do.
template <class Take>
void for_each_frame(const Sequence& sequence, std::string_view stage, const Progress& progress,
                    Take&& take) {
  const auto read = [&](std::size_t i) {
    return std::async(std::launch::async, [&sequence, i] { return sequence.read(i); });
  };
  std::future<Frame> next = read(0);  // a sequence has a frame
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (progress) progress(stage, double(i) / double(sequence.size()));
    const Frame frame = next.get();
    if (i + 1 < sequence.size()) next = read(i + 1);
    take(i, frame);
  }
  if (progress) progress(stage, 1);
}

}  // namespace planescope::sequence
