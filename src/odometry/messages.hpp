// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>

/// \file What planescope and planescope-odometry say to each other, over one socket that is the
/// program's standard input. Both are of one build, so structures go as they lie in memory.
namespace planescope::odometry {

inline constexpr std::uint64_t kMagic = 0x31304f4453505cULL;  // changes with the messages

/// First of all; answered by a Reply, so that one knows that the program runs.
struct Hello {
  std::uint64_t magic = kMagic;
  std::uint32_t width = 0, height = 0;    // [pixel]
  double fx = 0, fy = 0, cx = 0, cy = 0;  // [pixel]
  double min_depth = 0, max_depth = 0;    // [m]
};

enum class Do : std::uint32_t {
  Take,   ///< depths [m] (0: none) and brightnesses [0, 1], width * height floats each, follow
  Keep,   ///< the frame taken last is the one that others are put to
  Match,  ///< answered by a Reply
};

struct Request {
  Do what = Do::Take;
  std::uint32_t has_color = 0;        // Take: the brightnesses mean something
  std::array<double, 16> guess = {};  // Match: by columns
};

struct Reply {
  std::uint64_t magic = kMagic;
  std::uint64_t found = 0;             // 0 or 1
  double share = 0;                    // FrameMatch::share
  std::array<double, 16> motion = {};  // by columns
};

}  // namespace planescope::odometry
