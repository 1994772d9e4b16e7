// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/whole_file.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "planescope/error.hpp"

namespace planescope {
namespace fs = std::filesystem;

WholeFile::WholeFile(fs::path target) : target_(std::move(target)) {
  const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw Error(Error::Kind::Input, target_.string() + ": the folder " + folder.string() +
                                        " does not exist; make it or name another");
  }
  static std::atomic<unsigned> counter = 0;  // two threads may write into one folder
  temporary_ =
      folder / (std::string(".") + target_.stem().string() + "." + std::to_string(::getpid()) +
                "-" + std::to_string(counter++) + target_.extension().string());
}

WholeFile::~WholeFile() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove(temporary_, ignored);
}

void WholeFile::commit() {
  std::error_code failure;
  fs::rename(temporary_, target_, failure);
  if (failure) {
    throw Error(Error::Kind::Input,
                target_.string() + ": cannot be put in place: " + failure.message());
  }
  temporary_.clear();
}

void write_whole(const fs::path& target, std::string_view bytes) {
  WholeFile file(target);
  const auto fail = [&] {
    throw Error(Error::Kind::Input, target.string() + ": cannot be written: " +
                                        std::strerror(errno) + "; is the disk full?");
  };
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.temporary().c_str(), "wb"),
                                                      &std::fclose);
  if (!out || std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) fail();
  if (std::fclose(out.release()) != 0) fail();
  file.commit();
}

}  // namespace planescope
