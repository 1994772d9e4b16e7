// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/staged_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

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

constexpr const char* kPrefix = ".planescope-";

int open_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK);
}

/// Removes what killed processes have staged here: folders of ours that nobody holds.
void remove_abandoned(const fs::path& place) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place, ignored)) {
    if (!entry.path().filename().string().starts_with(kPrefix)) continue;
    const int folder = open_folder(entry.path());
    if (folder < 0) continue;
    if (::flock(folder, LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry.path(), ignored);
    ::close(folder);
  }
}

/// One publisher at a time in a folder; without locks (some network file systems) it does not wait.
class PublishLock {
 public:
  explicit PublishLock(const fs::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~PublishLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  PublishLock(const PublishLock&) = delete;
  PublishLock& operator=(const PublishLock&) = delete;

 private:
  int descriptor_;
};

/// Again until the folder is gone: somebody may still write into it.
void remove_staged(const fs::path& staging) {
  std::error_code failure;
  for (int tries = 0; tries < 100 && fs::exists(staging, failure); ++tries)
    fs::remove_all(staging, failure);
}

}  // namespace

void refuse_overwriting(const fs::path& input, const fs::path& folder,
                        const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!fs::equivalent(input, folder / name, ignored)) continue;
    throw Error(Error::Kind::Usage, input.string() +
                                        ": the result has a file of this name too, and would "
                                        "overwrite the input; name another folder with -o");
  }
}

void check_writable(const fs::path& folder) {
  const fs::path place = nearest_existing(folder);
  if (!fs::is_directory(place)) fail(place, "is a file, where a folder should be");
  if (::access(place.c_str(), W_OK | X_OK) != 0) {
    fail(place, std::string("cannot be written: ") + std::strerror(errno));
  }
}

StagedFolder::StagedFolder(const fs::path& target)
    : target_(target), undo_([this] { remove_staged(staging_); }) {
  check_writable(target);
  const fs::path place = nearest_existing(target);
  remove_abandoned(place);
  constexpr int kTries = 10;  // another process may take a new folder for an abandoned one
  for (int tries = 0; tries < kTries; ++tries) {
    if (stage(place)) return;
  }
  fail(target, "cannot be written: other processes remove what is begun there");
}

bool StagedFolder::stage(const fs::path& place) {
  const EndingPause known;
  std::string name = (place / kPrefix).string() + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) {
    fail(target_, std::string("cannot be written: ") + std::strerror(errno));
  }
  lock_ = open_folder(name);
  const bool taken = lock_ < 0 || (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK);
  struct stat status {};
  if (taken || ::fstat(lock_, &status) != 0 || status.st_nlink == 0) {
    if (lock_ >= 0) ::close(std::exchange(lock_, -1));
    return false;
  }
  staging_ = name;
  return true;
}

StagedFolder::~StagedFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

std::vector<std::string> StagedFolder::publish(const std::string& key,
                                               const std::vector<std::string>& owned) try {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(staging_)) {
    names.push_back(file.path().filename().string());
  }
  std::ranges::sort(names);
  fs::create_directories(target_);
  const PublishLock alone(target_);
  const EndingPause whole;
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
