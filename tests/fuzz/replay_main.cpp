// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

#include "fuzz_target.hpp"

/// \file Every file of the folders that are named goes through the target once: what hurt once is
/// tried in every test run. Ends with 1 where there is no file, so that no empty folder passes.
int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  std::vector<fs::path> files;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : fs::recursive_directory_iterator(argv[i]))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    std::printf("%s\n", file.c_str());
    std::fflush(stdout);  // a crash then names its file
    std::ifstream in(file, std::ios::binary);
    planescope::fuzzing::fuzz(std::string{std::istreambuf_iterator<char>(in), {}});
  }
  return files.empty() ? 1 : 0;
}
