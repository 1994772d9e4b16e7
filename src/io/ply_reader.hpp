// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/assemble.hpp"
#include "io/input_file.hpp"
#include "planescope/io.hpp"

/// \file Reading PLY files: ascii, little and big endian.
namespace planescope::io {

/// Reads the element `vertex`; elements before it are passed over within the file's bounds, those
/// after it are not looked at. \throws Error{Kind::Input} malformed, truncated, beyond the limits;
/// no finite point.
Assembled read_ply(const InputFile& file, const ReadLimits& limits);

}  // namespace planescope::io
