// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace planescope::bench {

/// Peak memory of a process that reads a room and segments it: `who` is `ours`, `pcl`, or `both`
/// (a child process each, and their ratio). `file`: the room, where it is stored already, else
/// empty. \returns the exit code.
int run_memory(const std::string& who, std::uint64_t points, const std::filesystem::path& file);

}  // namespace planescope::bench
