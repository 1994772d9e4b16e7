// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "json_file.hpp"

#include <fstream>

#include "planescope/error.hpp"

namespace planescope {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what, std::string_view hint) {
  throw Error(Error::Kind::Input, name + ": " + what + "; " + std::string(hint));
}

}  // namespace

std::string read_json_text(const std::filesystem::path& file, std::string_view hint) {
  std::error_code failure;
  const bool regular = std::filesystem::is_regular_file(file, failure);  // a pipe would hang
  const std::uintmax_t size = regular ? std::filesystem::file_size(file, failure) : 0;
  if (!regular || failure) fail(file.string(), "missing, or no file that can be read", hint);
  if (size > kMaxJsonBytes)
    fail(file.string(), "has " + std::to_string(size) + " bytes, more than 256 MiB", hint);
  std::ifstream in(file, std::ios::binary);
  std::string text(size, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size)))
    fail(file.string(), "cannot be read", hint);
  return text;
}

nlohmann::json parse_json(const std::string& text, const std::string& name, std::string_view hint) {
  using Json = nlohmann::json;
  const auto bounded = [&](int depth, Json::parse_event_t event, Json&) {
    const bool opens =
        event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && depth >= kMaxJsonDepth)
      fail(name, "is nested more than " + std::to_string(kMaxJsonDepth) + " deep", hint);
    return true;
  };
  try {
    return Json::parse(text, bounded);
  } catch (const Json::parse_error& error) {
    fail(name, "is not JSON at byte " + std::to_string(error.byte), hint);
  } catch (const Json::exception&) {
    fail(name, "holds a number that is out of range", hint);
  }
}

nlohmann::json read_json(const std::filesystem::path& file, std::string_view hint) {
  return parse_json(read_json_text(file, hint), file.string(), hint);
}

}  // namespace planescope
