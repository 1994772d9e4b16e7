// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string_view>

namespace planescope {

/// Writes bytes as a file that appears whole or not at all. \throws Error{Kind::Input} the folder
/// is missing, read-only, or the disk is full.
void write_whole(const std::filesystem::path& target, std::string_view bytes);

}  // namespace planescope
