// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "planescope/error.hpp"

/// \file What the fuzz targets share. A target defines fuzz(bytes); a libFuzzer build calls it with
/// mutated bytes, the replay program with the files of tests/malformed.
namespace planescope::fuzzing {

/// Hands untrusted bytes to one reader. May throw Error of the kinds that the reader documents;
/// anything else is a bug.
void fuzz(std::string_view bytes);

/// Calls `read`; only the refusals that users may see are swallowed.
template <class Read>
void refused_or_taken(Read&& read) {
  try {
    read();
  } catch (const Error& error) {
    const bool ours = error.kind() == Error::Kind::Input || error.kind() == Error::Kind::Usage;
    const std::string_view what = error.what();
    if (!ours || what.empty() || what.find('\n') != std::string_view::npos) std::abort();
  }
}

/// A folder in memory where the system has such a place; gone with the process.
class ScratchFolder {
 public:
  ScratchFolder() {
    const std::filesystem::path memory = "/dev/shm";
    const auto place =
        ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
    std::string name = (place / "planescope-fuzz-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    folder_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream out(folder_ / name, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return folder_ / name;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace planescope::fuzzing
