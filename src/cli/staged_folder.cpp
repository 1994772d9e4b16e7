// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/staged_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& why) {
  throw Error(Error::Kind::Input, folder.string() + ": " + why + "; name another with -o");
}

/// The folder itself, or the nearest one above it that exists.
fs::path nearest_existing(const fs::path& folder) {
  fs::path place = fs::absolute(folder);
  while (!fs::exists(place) && place.has_relative_path()) place = place.parent_path();
  return place;
}

}  // namespace

void check_writable(const fs::path& folder) {
  const fs::path place = nearest_existing(folder);
  if (!fs::is_directory(place)) fail(place, "is a file, where a folder should be");
  if (::access(place.c_str(), W_OK | X_OK) != 0) {
    fail(place, std::string("cannot be written: ") + std::strerror(errno));
  }
}

StagedFolder::StagedFolder(const fs::path& target) : target_(target) {
  check_writable(target);
  std::string name = (nearest_existing(target) / ".planescope-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    fail(target, std::string("cannot be written: ") + std::strerror(errno));
  }
  staging_ = name;
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
}

std::vector<std::string> StagedFolder::publish(const std::string& key,
                                               const std::vector<std::string>& owned) try {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(staging_)) {
    names.push_back(file.path().filename().string());
  }
  std::ranges::sort(names);
  fs::create_directories(target_);
  if (fs::remove(target_ / key)) {  // a result of ours was here: none of its files outlives it
    for (const std::string& name : owned) {
      if (!std::ranges::binary_search(names, name)) fs::remove(target_ / name);
    }
  }
  for (const std::string& name : names) {
    if (name != key) fs::rename(staging_ / name, target_ / name);
  }
  fs::rename(staging_ / key, target_ / key);
  return names;
} catch (const fs::filesystem_error& error) {
  fail(target_, "cannot be written: " + error.code().message());
}

}  // namespace planescope::cli
