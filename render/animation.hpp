// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

/// \file Animated PNG: browsers and ffmpeg play it, others show its first picture.
namespace planescope::draw {

/// Encoded pictures of one size and kind as one APNG that plays for ever, each shown for
/// `milliseconds`. The first one's notes are kept. \throws Error{Kind::Input} one is no PNG.
std::string animate(const std::vector<std::string>& pngs, int milliseconds);

}  // namespace planescope::draw
