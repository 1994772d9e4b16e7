// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <string>

#include "cli/config.hpp"
#include "planescope/options.hpp"

namespace CLI {
class App;
}

namespace planescope::cli {

/// The options of segment() from the command line and a configuration file: a preset, what the file
/// says of it, what the command line says of both.
class EngineArguments {
 public:
  static constexpr const char* kGroup = "Options of the engine";
  static constexpr const char* kPresetGroup = "Presets and files";

  /// Adds --preset, --config, and every option of option_table() by its name.
  void declare(CLI::App& command);

  /// Reads the configuration file and checks every name and value, before anything is computed.
  /// \throws Error{Kind::Usage} a bad value; \throws Error{Kind::Input} see read_config().
  void check();

  /// `auto`, `room` or `tabletop`, once check() was called.
  const std::string& preset() const { return preset_; }

  /// The options for this cloud. \throws Error{Kind::Usage} they contradict each other.
  Options resolve(const PointCloud& cloud, const std::optional<CloudScale>& scale = {}) const;

 private:
  struct Given {
    std::string name, flag, text;
    bool seen = false;
  };

  void apply(Options& options) const;

  std::string preset_, config_file_;
  Config config_;
  std::deque<Given> given_;  ///< a deque: CLI11 keeps references to its elements
};

}  // namespace planescope::cli
