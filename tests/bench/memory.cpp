// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "memory.hpp"

#include <stdio.h>  // popen
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "baselines/baselines.hpp"
#include "inputs.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"

namespace planescope::bench {
namespace {

/// Peak resident memory of this process [MB].
double peak_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024.0;
  }
  throw std::runtime_error("no VmHWM in /proc/self/status");
}

double copy_mb(const PointCloud& cloud) {
  const std::size_t bytes =
      cloud.positions.size() * sizeof(Eigen::Vector3f) + cloud.colors.size() * sizeof(Rgb) +
      cloud.normals.size() * sizeof(Eigen::Vector3f) + cloud.labels.size() * sizeof(std::uint32_t);
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

/// In the child: nothing but reading and the method, so that the peak is theirs. A user of PCL has
/// no cloud of ours in memory, so that copy is taken off PCL's peak.
double measure(const std::string& who, const std::filesystem::path& file) {
  const PointCloud cloud = read_cloud(file);
  const Options options = room_options(0.01, 0.10);
  if (who == "ours") {
    const Segmentation scene = segment(cloud, options);
    return peak_mb();
  }
  LccpOptions same{.patches = options.patches};
  same.keep_graph = false;
  const PeerResult result = lccp(cloud, same);
  return peak_mb() - copy_mb(cloud);
}

double measure_in_child(const std::string& who, const std::filesystem::path& file) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command = "'" + self + "' --memory " + who + " --file '" + file.string() + "'";
  FILE* child = ::popen(command.c_str(), "r");
  double mb = 0;
  const bool answered = child != nullptr && std::fscanf(child, "%lf", &mb) == 1;
  const int status = child != nullptr ? ::pclose(child) : -1;
  if (!answered || status != 0) throw std::runtime_error("the child failed: " + command);
  return mb;
}

}  // namespace

int run_memory(const std::string& who, std::uint64_t points, const std::filesystem::path& file) {
  if (who != "ours" && who != "pcl" && who != "both") {
    std::fprintf(stderr, "--memory %s: expected ours, pcl or both\n", who.c_str());
    return 2;
  }
  if (who != "both" && !file.empty()) {
    std::printf("%.1f\n", measure(who, file));
    return 0;
  }
  const std::filesystem::path stored =
      std::filesystem::temp_directory_path() /
      ("planescope-bench-memory-" + std::to_string(::getpid()) + ".pcd");
  write_cloud(room(points), stored);
  const auto say = [&](const char* name) {
    const double mb = measure_in_child(name, stored);
    std::printf("%-5s %9.1f MB peak at %llu points\n", name, mb,
                static_cast<unsigned long long>(points));
    return mb;
  };
  const double ours = who != "pcl" ? say("ours") : 0;
  const double pcl = who != "ours" ? say("pcl") : 0;
  std::filesystem::remove(stored);
  if (who == "both")
    std::printf("ours / pcl %.3f, promised <= 0.25  %s\n", ours / pcl,
                ours / pcl <= 0.25 ? "met" : "MISSED");
  return 0;
}

}  // namespace planescope::bench
