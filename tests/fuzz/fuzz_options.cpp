// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/config.hpp"
#include "fuzz_target.hpp"
#include "planescope/options.hpp"

/// \file The options' parsers: the bytes are a TOML file, and its lines are names and values too.
namespace planescope::fuzzing {
namespace {

/// `name=value`; what is taken must come back by get_option() as the same text.
void set_line(Options& options, std::string_view line) {
  const std::size_t split = line.find('=');
  if (split == std::string_view::npos) return;
  const std::string_view name = line.substr(0, split);
  set_option(options, name, line.substr(split + 1));
  const std::string text = get_option(options, name);
  set_option(options, name, text);
  if (get_option(options, name) != text) std::abort();
}

}  // namespace

void fuzz(std::string_view bytes) {
  static const ScratchFolder folder;
  Options options;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
    refused_or_taken([&] { set_line(options, bytes.substr(at, end - at)); });
    at = end + 1;
  }
  refused_or_taken([&] { options.validate(); });
  const auto file = folder.write("options.toml", bytes);
  refused_or_taken([&] {
    for (const cli::Setting& setting : cli::read_config(file).settings)
      set_option(options, setting.name, setting.value);
  });
}

}  // namespace planescope::fuzzing
