// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/input_file.hpp"
#include "planescope/io.hpp"

namespace planescope::io {

/// read_cloud() of an open file, or of bytes in memory (tests, fuzzing).
PointCloud read_cloud(const InputFile& file, const ReadLimits& limits = {});

}  // namespace planescope::io
