// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "speed.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include <tbb/global_control.h>

#include "baselines/baselines.hpp"
#include "hash_floor.hpp"
#include "inputs.hpp"
#include "patches/voxel_grid.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/sequence.hpp"

namespace planescope::bench {

struct Inputs {
  std::map<std::string, std::function<PointCloud()>> recipes;
  std::map<std::string, PointCloud> made;
  std::filesystem::path stored;  ///< a 4-million-point binary PCD, removed in the end

  const PointCloud& operator[](const std::string& name) {
    const auto at = made.find(name);
    return at != made.end() ? at->second : made.emplace(name, recipes.at(name)()).first->second;
  }

  const std::filesystem::path& file() {
    if (stored.empty()) {
      stored = std::filesystem::temp_directory_path() /
               ("planescope-bench-" + std::to_string(::getpid()) + ".pcd");
      write_cloud((*this)["room 4M"], stored);
    }
    return stored;
  }

  ~Inputs() {
    std::error_code ignored;
    if (!stored.empty()) std::filesystem::remove(stored, ignored);
  }
};

namespace {

using Shared = std::shared_ptr<Inputs>;

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void timing(const std::string& name, const std::function<double(benchmark::State&)>& once) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [once](benchmark::State& state) {
                                 for (auto _ : state) state.SetIterationTime(once(state));
                               })
      ->UseManualTime()
      ->MeasureProcessCPUTime()  // beside the wall clock: steadier where others use the machine
      ->Iterations(1)
      ->Repetitions(5)
      ->ReportAggregatesOnly(true)
      ->Unit(benchmark::kMillisecond);
}

void per_point(benchmark::State& state, double time, const PointCloud& cloud) {
  state.counters["ns_per_point"] = 1e9 * time / static_cast<double>(cloud.size());
}

/// The whole engine, reading excluded. Counters: ns a point, the share of all after patches, and
/// the share of the 33 ms that a camera gives a frame.
void engine_timing(const Shared& inputs, const std::string& name, const std::string& cloud_name,
                   std::size_t threads, const Options& options) {
  timing(name, [=](benchmark::State& state) {
    const PointCloud& cloud = (*inputs)[cloud_name];
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    StageTimes times;
    const double time = seconds([&] { times = segment(cloud, options).times; });
    per_point(state, time, cloud);
    state.counters["patches_ns_per_point"] =
        1e6 * times.patches / static_cast<double>(cloud.size());
    state.counters["of_33_ms"] = time / 0.033;
    state.counters["after_patches"] = 1.0 - times.patches / (1e3 * time);
    return time;
  });
}

/// PCL's supervoxels and LCCP: the time of PCL's own calls; conversions are left out.
void pcl_timing(const Shared& inputs, const std::string& cloud_name, const Options& options) {
  timing("pcl " + cloud_name, [=](benchmark::State& state) {
    const PointCloud& cloud = (*inputs)[cloud_name];
    LccpOptions same{.patches = options.patches};
    same.keep_graph = false;
    const double time = 1e-3 * lccp(cloud, same).times.method();
    per_point(state, time, cloud);
    return time;
  });
}

void compare(const Shared& inputs, const std::string& cloud_name, const Options& options) {
  for (const std::size_t threads : {1U, 2U})
    engine_timing(inputs, "ours " + cloud_name + " threads " + std::to_string(threads), cloud_name,
                  threads, options);
  pcl_timing(inputs, cloud_name, options);
}

/// A stored view as `segment --depth` gets it: a depth image, what auto makes of it, and how long
/// that takes.
void single_view(const Shared& inputs, const std::string& name, const std::filesystem::path& view,
                 const PinholeCamera& lens) {
  if (!std::filesystem::exists(view)) return;
  inputs->recipes[name] = [=] { return as_depth_view(read_cloud(view), lens); };
  compare(inputs, name, Options::automatic((*inputs)[name]));
  timing("auto " + name, [=](benchmark::State&) {
    const PointCloud& cloud = (*inputs)[name];
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
    return seconds([&] { benchmark::DoNotOptimize(Options::automatic(cloud)); });
  });
}

void voxel_timings(const Shared& inputs) {
  timing("voxel grid 4M threads 1", [=](benchmark::State& state) {
    const PointCloud& cloud = (*inputs)["room 4M"];
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const double time =
        seconds([&] { benchmark::DoNotOptimize(make_voxel_grid(cloud, 0.01, false)); });
    per_point(state, time, cloud);
    return time;
  });
  timing("hash floor 4M", [=](benchmark::State& state) {
    const PointCloud& cloud = (*inputs)["room 4M"];
    const double time = seconds([&] { benchmark::DoNotOptimize(hash_pass(cloud, 0.01)); });
    per_point(state, time, cloud);
    return time;
  });
}

void read_timings(const Shared& inputs) {
  timing("read 4M", [=](benchmark::State&) {
    const std::filesystem::path& file = inputs->file();
    return seconds([&] { benchmark::DoNotOptimize(read_cloud(file)); });
  });
  timing("cat 4M", [=](benchmark::State& state) {
    const std::string command = "cat '" + inputs->file().string() + "' > /dev/null";
    int status = 0;
    const double time = seconds([&] { status = std::system(command.c_str()); });
    if (status != 0) state.SkipWithError("cat failed");
    return time;
  });
}

}  // namespace

std::shared_ptr<Inputs> register_timings(const std::filesystem::path& data) {
  const auto inputs = std::make_shared<Inputs>();
  const std::filesystem::path view = data / "mosd_learn" / "learn0.pcd";
  inputs->recipes["room 1M"] = [] { return room(1'000'000); };
  inputs->recipes["room 4M"] = [] { return room(4'000'000); };
  inputs->recipes["rooms 16M"] = [] { return tiled(room(1'000'000), 4, 4); };
  inputs->recipes["kinect"] = [view] { return read_cloud(view); };
  if (std::filesystem::exists(view)) compare(inputs, "kinect", Options::tabletop());
  single_view(inputs, "learn0 depth", view, named_camera("primesense"));
  single_view(inputs, "TUM depth", data / "tum" / "1341847980.723020.pcd", named_camera("tum_fr3"));
  compare(inputs, "room 1M", room_options(0.01, 0.10));
  compare(inputs, "room 4M", room_options(0.01, 0.10));
  engine_timing(inputs, "growth 1M", "room 1M", 1, room_options(0.01, 0.10));
  engine_timing(inputs, "growth 16M", "rooms 16M", 1, room_options(0.01, 0.10));
  engine_timing(inputs, "fine 4M", "room 4M", 2, room_options(0.0075, 0.03));
  voxel_timings(inputs);
  read_timings(inputs);
  return inputs;
}

std::vector<Ratio> promised_ratios() {
  return {
      {"PCL / ours, Kinect view, 2 threads", "pcl kinect", "ours kinect threads 2", 8},
      {"PCL / ours, Kinect view, 1 thread", "pcl kinect", "ours kinect threads 1", 5},
      {"PCL / ours, learn0 as a depth image, 2 threads", "pcl learn0 depth",
       "ours learn0 depth threads 2", 5},
      {"PCL / ours, a TUM frame as a depth image, 2 threads", "pcl TUM depth",
       "ours TUM depth threads 2", 5},
      {"learn0 as a depth image / 33 ms, 2 threads", "ours learn0 depth threads 2:of_33_ms", "", 1,
       false},
      {"a TUM frame as a depth image / 33 ms, 2 threads", "ours TUM depth threads 2:of_33_ms", "",
       1, false},
      {"PCL / ours, room of 1M points, 2 threads", "pcl room 1M", "ours room 1M threads 2", 12},
      {"PCL / ours, room of 1M points, 1 thread", "pcl room 1M", "ours room 1M threads 1", 8},
      {"PCL / ours, room of 4M points, 2 threads", "pcl room 4M", "ours room 4M threads 2", 12},
      {"PCL / ours, room of 4M points, 1 thread", "pcl room 4M", "ours room 4M threads 1", 8},
      {"ns a point, 16M / 1M, whole engine", "growth 16M:ns_per_point", "growth 1M:ns_per_point",
       1.25, false},
      {"ns a point, 16M / 1M, patches", "growth 16M:patches_ns_per_point",
       "growth 1M:patches_ns_per_point", 1.25, false},
      {"share after patches, 4M points at 0.75 cm and 3 cm", "fine 4M:after_patches", "", 0.2,
       false},
      {"voxelise, label, link neighbours / hash pass, 4M, 1 thread", "voxel grid 4M threads 1",
       "hash floor 4M", 2, false},
      {"read_cloud / cat, binary PCD of 4M points", "read 4M", "cat 4M", 4, false},
  };
}

}  // namespace planescope::bench
