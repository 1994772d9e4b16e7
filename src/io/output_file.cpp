// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>
#include <utility>

#include "planescope/error.hpp"

namespace planescope::io {

OutputFile::OutputFile(const std::filesystem::path& target)
    : target_(target),
      whole_(target),
      // O_EXCL: never through a link that someone put in the temporary's place.
      descriptor_(
          ::open(whole_.temporary().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail();
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail();
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void OutputFile::commit() {
  if (::close(std::exchange(descriptor_, -1)) != 0) fail();
  whole_.commit();
}

void OutputFile::fail() const {
  throw Error(Error::Kind::Input, target_.string() +
                                      ": cannot be written: " + std::strerror(errno) +
                                      "; is the disk full, or the folder read-only?");
}

}  // namespace planescope::io
