// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "planescope/pipeline.hpp"
#include "planescope/render.hpp"
#include "planescope/synthesize.hpp"

/// \file Many scenes, one after the other, in one process: what a service that links the library
/// does. soak RUNS PNG: ends with 1 where the resident memory keeps growing.
namespace {

double resident_mb() {
  std::ifstream statm("/proc/self/statm");
  std::size_t size = 0, resident = 0;
  statm >> size >> resident;
  return double(resident) * double(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// Sizes, options and pictures differ from run to run.
void run(std::uint64_t seed, const char* png) {
  using namespace planescope;
  SynthesisOptions room;
  room.random_seed = seed;
  room.points = 10'000 + 5'000 * (seed % 5);
  const SynthesizedScene scene = synthesize(room);
  const Segmentation result = segment(scene.cloud, Options::automatic(scene.cloud));
  const Layer layers[] = {Layer::Segments, Layer::Planes, Layer::Graph, Layer::Scene};
  RenderOptions drawing;
  drawing.layers = layers[seed % 4];
  drawing.size = {320 + 16 * static_cast<int>(seed % 7), 240};
  render(result, scene.cloud, drawing, png);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto runs = static_cast<std::uint64_t>(std::strtoull(argv[1], nullptr, 10));
  std::vector<double> resident;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    run(seed, argv[2]);
    resident.push_back(resident_mb());
    if (seed % 25 == 0) std::printf("%3zu runs: %.1f MB\n", resident.size(), resident.back());
    std::fflush(stdout);
  }
  const auto third = static_cast<std::ptrdiff_t>(resident.size() / 3);
  const double second = median({resident.begin() + third, resident.begin() + 2 * third});
  const double last = median({resident.begin() + 2 * third, resident.end()});
  std::printf("second third %.1f MB, last third %.1f MB, peak %.1f MB\n", second, last,
              *std::max_element(resident.begin(), resident.end()));
  return last <= 1.03 * second + 2 ? 0 : 1;
}
