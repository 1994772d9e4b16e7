// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/config.hpp"

#include <toml++/toml.h>

#include <charconv>
#include <fstream>

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

/// The file's text, ASCII: Debian's toml++ is undefined where some letters stand in place of a
/// value's end. Comments may hold any; they are blanked.
/// \throws Error{Kind::Input} missing, too large, or with other letters elsewhere.
std::string read_ascii(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMost = 1 << 20;  // [byte]
  const auto fail = [&](const std::string& what) {
    throw Error(Error::Kind::Input, file.string() + what);
  };
  std::error_code failure;
  const bool regular = std::filesystem::is_regular_file(file, failure);  // a pipe would hang
  const std::uintmax_t size = regular ? std::filesystem::file_size(file, failure) : 0;
  if (!regular || failure) fail(": missing, or no file; name a TOML file with options");
  if (size > kMost)
    fail(": has " + std::to_string(size) + " bytes; expected options, at most 1 MB");
  std::string text(size, '\0');
  std::ifstream in(file, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) fail(": cannot be read");
  std::size_t line = 1;
  bool comment = false;
  for (char& c : text) {
    if (c == '\n') ++line;
    comment = c != '\n' && (comment || c == '#');
    if (static_cast<unsigned char>(c) < 128) continue;
    if (!comment)
      fail(":" + std::to_string(line) + ": has a letter that is not ASCII; only comments may");
    c = ' ';
  }
  return text;
}

toml::table parse(const std::filesystem::path& file) {
  const std::string text = read_ascii(file);
  try {
    return toml::parse(std::string_view(text), file.string());
  } catch (const toml::parse_error& error) {
    throw Error(Error::Kind::Input,
                place(file, error.source()) + ": " + std::string(error.description()));
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
