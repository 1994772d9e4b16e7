// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "planescope/image.hpp"

/// \file JPEG by libjpeg, in memory. Its errors are long jumps: they end here.
namespace planescope::io {

bool is_jpeg(std::span<const std::byte> bytes);

/// \param name of where the bytes are from, for messages.
/// \throws Error{Kind::Input} truncated, damaged, too large, or of colours that have no RGB (CMYK).
ColorImage decode_jpeg(const std::string& name, std::span<const std::byte> bytes);

}  // namespace planescope::io
