// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

/// \file JSON that somebody else may have written.
namespace planescope {

inline constexpr std::uintmax_t kMaxJsonBytes = std::uintmax_t{256} << 20;
/// Ours nest less than ten deep. Beyond some thousands, whatever walks the tree by recursion
/// (dump() does) overflows the stack.
inline constexpr int kMaxJsonDepth = 64;

/// The whole text of a regular file of at most kMaxJsonBytes.
/// \param hint what to do where it cannot be read; ends the message.
/// \throws Error{Kind::Input}
std::string read_json_text(const std::filesystem::path& file, std::string_view hint);

/// Parses text that nobody has checked.
/// \throws Error{Kind::Input} not JSON (says the byte), or nested more than kMaxJsonDepth deep.
nlohmann::json parse_json(const std::string& text, const std::string& name, std::string_view hint);

/// Both of them.
nlohmann::json read_json(const std::filesystem::path& file, std::string_view hint);

}  // namespace planescope
