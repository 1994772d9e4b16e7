// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause

// planescope_bench: ours and PCL's in one process on the same clouds, medians of 5, and the ratios
// that are promised.
//   planescope_bench [--data FOLDER] [Google Benchmark's options, such as
//   --benchmark_filter=kinect] planescope_bench --memory ours|pcl|both [--points N]
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "freed_memory.hpp"
#include "inputs.hpp"
#include "memory.hpp"
#include "speed.hpp"

namespace {

/// Takes `--name value` out of the arguments. \returns the value, or an empty string.
std::string take(std::vector<char*>& arguments, const std::string& name) {
  for (std::size_t i = 1; i + 1 < arguments.size(); ++i) {
    if (name != arguments[i]) continue;
    const std::string value = arguments[i + 1];
    const auto at = arguments.begin() + static_cast<std::ptrdiff_t>(i);
    arguments.erase(at, at + 2);
    return value;
  }
  return {};
}

int run(std::vector<char*> arguments) {
  using namespace planescope::bench;
  const std::string memory = take(arguments, "--memory"), points = take(arguments, "--points"),
                    file = take(arguments, "--file"), data = take(arguments, "--data");
  if (!memory.empty())
    return run_memory(memory, points.empty() ? 4'000'000 : std::stoull(points), file);
  const auto inputs = register_timings(data_folder(data));
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  MedianReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  print_ratios(promised_ratios(), reporter.medians);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  planescope::keep_freed_memory();  // as the command line does
  try {
    return run({argv, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "planescope_bench: %s\n", error.what());
    return 1;
  }
}
