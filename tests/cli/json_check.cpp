// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <regex.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

/// json_check FILE [PATH [REGEX]]: exits with 0 if FILE is JSON, PATH is in it (keys and, in lists,
/// numbers, joined by slashes), and its value as text matches REGEX, extended. POSIX's matcher: GCC
/// warns of uninitialised memory within std::regex where sanitizers are on.
namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> keys(1);
  for (const char c : path) {
    if (c == '/') {
      keys.emplace_back();
    } else {
      keys.back() += c;
    }
  }
  return keys;
}

bool matches(const std::string& text, const char* pattern) {
  regex_t regex;
  if (regcomp(&regex, pattern, REG_EXTENDED | REG_NOSUB) != 0) {
    throw std::invalid_argument(std::string("not a regular expression: ") + pattern);
  }
  const bool found = regexec(&regex, text.c_str(), 0, nullptr, 0) == 0;
  regfree(&regex);
  return found;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  std::ifstream in(argv[1]);
  nlohmann::json value = nlohmann::json::parse(in);
  if (argc < 3 || *argv[2] == '\0') return 0;
  for (const std::string& key : split(argv[2])) {
    value = value.is_array() ? nlohmann::json(value.at(std::stoul(key))) : value.at(key);
  }
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  if (argc < 4 || matches(text, argv[3])) return 0;
  std::fprintf(stderr, "%s is %s\n", argv[2], text.c_str());
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
