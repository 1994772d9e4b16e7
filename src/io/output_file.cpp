// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "planescope/error.hpp"

namespace planescope::io {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

std::string own_path(int descriptor) { return "/proc/self/fd/" + std::to_string(descriptor); }

/// Unique to this process, hidden, and short whatever the target's name: that may be as long as
/// the system allows.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;  // two threads may write into one folder
  return folder_of(target) /
         (".planescope." + std::to_string(::getpid()) + "-" + std::to_string(counter++));
}

}  // namespace

OutputFile::OutputFile(const fs::path& target)
    : target_(target), temporary_(temporary_name(target)), undo_([this] { remove_temporary(); }) {
  std::error_code ignored;
  if (!fs::is_directory(folder_of(target), ignored)) {
    throw Error(Error::Kind::Input, target_.string() + ": the folder " +
                                        folder_of(target).string() +
                                        " does not exist; make it or name another");
  }
  if (fs::is_directory(fs::symlink_status(target, ignored))) fail(EISDIR);
  open();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (named_) remove_temporary();
}

void OutputFile::open() {
  constexpr mode_t kMode = 0666;
#ifdef O_TMPFILE
  descriptor_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kMode);
  if (descriptor_ >= 0 && ::access(own_path(descriptor_).c_str(), F_OK) == 0) return;
  if (descriptor_ >= 0) ::close(descriptor_);  // without /proc it could never get a name
#endif
  // O_EXCL: never through a link that someone put in the temporary's place.
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
  if (descriptor_ < 0) fail(errno);
  named_ = true;
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void OutputFile::commit() {
  const EndingPause whole;  // the name and its place are one step
  if (!named_) {
    if (::linkat(AT_FDCWD, own_path(descriptor_).c_str(), AT_FDCWD, temporary_.c_str(),
                 AT_SYMLINK_FOLLOW) != 0)
      fail(errno);
    named_ = true;
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  named_ = false;
}

void OutputFile::remove_temporary() const {
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void OutputFile::fail(int why) const {
  throw Error(Error::Kind::Input, target_.string() + ": cannot be written: " + std::strerror(why) +
                                      "; is the disk full, or the folder read-only?");
}

}  // namespace planescope::io
