// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

#include "io/input_file.hpp"
#include "planescope/io.hpp"

namespace planescope::io {

/// \throws Error{Kind::Input} the header has more points than the caller wants to take.
inline void check_limits(const InputFile& file, std::uint64_t points, const ReadLimits& limits) {
  if (points <= limits.max_points) return;
  file.fail("the header has " + std::to_string(points) + " points, the limit is " +
            std::to_string(limits.max_points) + "; thin the cloud out or raise the limit");
}

}  // namespace planescope::io
