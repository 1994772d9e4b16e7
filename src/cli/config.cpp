// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/config.hpp"

#include <toml++/toml.h>

#include <charconv>

#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

std::string place(const std::filesystem::path& file, const toml::source_region& source) {
  return file.string() + ":" + std::to_string(source.begin.line);
}

/// A value as the text that set_option() takes; nothing for dates, lists and tables.
std::optional<std::string> text(const toml::node& node) {
  if (const auto* value = node.as_string()) return value->get();
  if (const auto* value = node.as_integer()) return std::to_string(value->get());
  if (const auto* value = node.as_boolean()) return value->get() ? "true" : "false";
  if (const auto* value = node.as_floating_point()) {
    char buffer[32];
    return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value->get()).ptr);
  }
  return std::nullopt;
}

[[noreturn]] void refuse(const std::string& where, const std::string& key) {
  throw Error(Error::Kind::Usage,
              where + ": `" + key +
                  "` is not an option; it takes preset = \"...\" and options in their groups, such "
                  "as [planes] sigma = 0.03");
}

toml::table parse(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    const bool opened = error.source().begin.line > 0;
    throw Error(Error::Kind::Input, (opened ? place(file, error.source()) : file.string()) + ": " +
                                        std::string(error.description()));
  }
}

}  // namespace

Config read_config(const std::filesystem::path& file) {
  Config config;
  for (const auto& [key, node] : parse(file)) {
    const std::string group(key.str());
    const std::string where = place(file, node.source());
    if (group == "preset" && node.is_string()) {
      config.preset = text(node);
      continue;
    }
    if (!node.is_table()) refuse(where, group);
    for (const auto& [member, value] : *node.as_table()) {
      const std::string name = group + "." + std::string(member.str());
      const auto value_text = text(value);
      if (!value_text) refuse(place(file, value.source()), name);
      config.settings.push_back({name, *value_text, place(file, value.source())});
    }
  }
  return config;
}

}  // namespace planescope::cli
