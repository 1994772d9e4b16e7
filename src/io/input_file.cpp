// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "planescope/error.hpp"

namespace planescope::io {

InputFile::InputFile(const std::filesystem::path& file, const std::string& expected)
    : name_(file.string()) {
  // O_NONBLOCK: opening a pipe that nobody writes to must not hang; regular files ignore it.
  descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) {
    fail(std::string("cannot be opened: ") + std::strerror(errno) + "; expected " + expected);
  }
  struct stat status {};
  const bool regular = ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  size_ = regular && status.st_size > 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
  if (size_ == 0) {
    ::close(descriptor_);  // the destructor of a half-made object does not run
    if (!regular) fail("is not a regular file; expected " + expected);
    fail("is empty; expected " + expected);
  }
}

InputFile::InputFile(std::string name, std::span<const std::byte> bytes)
    : name_(std::move(name)), size_(bytes.size()), memory_(bytes) {
  if (bytes.empty()) fail("is empty; expected a PCD or PLY file");
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void InputFile::read_at(std::uint64_t offset, std::span<std::byte> to) const {
  if (offset > size_ || to.size() > size_ - offset) {
    fail_byte(size_, "the file ends here, " + std::to_string(to.size()) +
                         " bytes were expected from byte " + std::to_string(offset) +
                         " on; it is truncated, fetch it again");
  }
  if (descriptor_ < 0) {
    if (!to.empty()) std::memcpy(to.data(), memory_.data() + offset, to.size());
    return;
  }
  while (!to.empty()) {
    const ssize_t got = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_byte(offset, std::string("cannot be read: ") + std::strerror(errno));
    if (got == 0) fail_byte(offset, "the file became shorter while it was read; read it again");
    to = to.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::uint64_t>(got);
  }
}

void InputFile::fail(const std::string& what) const {
  throw Error(Error::Kind::Input, name_ + ": " + what);
}

void InputFile::fail_line(std::uint64_t line, const std::string& what) const {
  fail("line " + std::to_string(line) + ": " + what);
}

void InputFile::fail_byte(std::uint64_t offset, const std::string& what) const {
  fail("byte " + std::to_string(offset) + ": " + what);
}

}  // namespace planescope::io
