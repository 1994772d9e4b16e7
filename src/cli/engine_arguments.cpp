// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/engine_arguments.hpp"

#include <CLI/CLI.hpp>

#include "automatic.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

/// The options that a user reaches for first have short names too.
std::string flags(const std::string& name) {
  if (name == "patches.voxel_size") return "--voxel-size,--" + name;
  if (name == "patches.patch_size") return "--patch-size,--" + name;
  if (name == "planes.random_seed") return "--random-seed,--" + name;
  return "--" + name;
}

std::string description(const OptionInfo& info) {
  const bool measured = info.unit == "m" || info.unit == "deg" || info.unit == "m^2";
  return info.meaning + " [" + info.range + (measured ? " " + info.unit : "") + "; room " +
         get_option(Options::room(), info.name) + "]";
}

Options base(const std::string& preset) {
  if (preset == "room") return Options::room();
  if (preset == "tabletop") return Options::tabletop();
  throw Error(Error::Kind::Usage, "preset is `" + preset + "`; it takes auto | room | tabletop");
}

}  // namespace

void EngineArguments::declare(CLI::App& command) {
  command
      .add_option("--preset", preset_,
                  "auto (from the cloud's spacing, noise and extent) | room | tabletop")
      ->type_name("NAME")
      ->group(kPresetGroup);
  command.add_option("--config", config_file_, "Options from a TOML file; the command line wins")
      ->type_name("FILE")
      ->group(kPresetGroup);
  for (const OptionInfo& info : option_table()) {
    Given& given = given_.emplace_back(Given{info.name, flags(info.name), {}});
    command.add_option(given.flag, given.text, description(info))
        ->type_name(info.unit == "1" ? "NUMBER" : info.unit)
        ->group(kGroup)
        ->each([&given](const std::string&) { given.seen = true; });
  }
}

void EngineArguments::check() {
  if (!config_file_.empty()) config_ = read_config(config_file_);
  if (preset_.empty()) preset_ = config_.preset.value_or("auto");
  Options options = base(preset_ == "auto" ? "room" : preset_);
  apply(options);
  if (preset_ != "auto") options.validate();
}

Options EngineArguments::resolve(const PointCloud& cloud,
                                 const std::optional<CloudScale>& scale) const {
  Options options = preset_ != "auto" ? base(preset_)
                    : scale           ? automatic_options(cloud, *scale)
                                      : Options::automatic(cloud);
  apply(options);
  options.validate();
  return options;
}

void EngineArguments::apply(Options& options) const {
  for (const Setting& setting : config_.settings) {
    try {
      set_option(options, setting.name, setting.value);
    } catch (const Error& error) {
      throw Error(error.kind(), setting.place + ": " + error.what());
    }
  }
  for (const Given& given : given_) {
    if (given.seen) set_option(options, given.name, given.text);
  }
}

}  // namespace planescope::cli
