// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planescope::cli {

/// One option from a configuration file.
struct Setting {
  std::string name;   ///< `planes.sigma`
  std::string value;  ///< as set_option() takes it
  std::string place;  ///< `file.toml:3`, for messages
};

/// A configuration file: `preset = "room"` and `[planes] sigma = 0.03`.
struct Config {
  std::optional<std::string> preset;
  std::vector<Setting> settings;
};

/// Reads TOML. Names and values of settings are not checked here.
/// \throws Error{Kind::Input} missing, or not TOML (with the line);
/// \throws Error{Kind::Usage} a key that is neither `preset` nor a number, flag or text in a group.
Config read_config(const std::filesystem::path& file);

}  // namespace planescope::cli
