// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

/// \file What several test files share.
namespace planescope::testing {

/// A shared data file, or an empty path where it is absent (then GTEST_SKIP() << missing(name)).
inline std::filesystem::path shared_data(const std::string& name) {
  const char* place = std::getenv("PLANESCOPE_DATA");
  const std::filesystem::path folder =
      place != nullptr ? place : std::filesystem::path(PLANESCOPE_SOURCE_DIR) / "../shared/data";
  const std::filesystem::path file = folder / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

inline std::string missing(const std::string& name) {
  return name + " is not here; set PLANESCOPE_DATA to the folder that has it";
}

/// A folder of its own for one test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "planescope-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace planescope::testing
