// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "planescope/render.hpp"

/// \file What options of a drawing may be.
namespace planescope::draw {

/// [pixel] of the picture that is drawn, before it is shrunk. Here all buffers together take about
/// 5 GB.
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 26;

/// \throws Error{Kind::Usage} an option is out of its range.
void validate(const RenderOptions& options);

}  // namespace planescope::draw
