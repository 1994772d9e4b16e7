// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/global_control.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/scene_arguments.hpp"
#include "planescope/error.hpp"
#include "planescope/fusion.hpp"
#include "planescope/io.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;
using TbbLimit = tbb::global_control;

struct Arguments {
  Console console;
  DepthArguments depth;
  fs::path sequence, cloud, mesh, trajectory;
  std::size_t threads = 0;
};

void check_output(const char* option, const fs::path& file, const std::vector<std::string>& ends) {
  if (std::ranges::find(ends, file.extension().string()) == ends.end()) {
    std::string takes;
    for (const std::string& end : ends) takes += (takes.empty() ? "*" : " or *") + end;
    throw Error(Error::Kind::Usage,
                std::string(option) + " is `" + file.string() + "`; it takes " + takes);
  }
  const fs::path folder = file.parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) {  // before minutes are spent
    throw Error(Error::Kind::Input, folder.string() + ": is no folder; make it first");
  }
  if (::access(folder.empty() ? "." : folder.c_str(), W_OK) != 0) {
    throw Error(Error::Kind::Input, (folder.empty() ? "." : folder.string()) +
                                        ": cannot be written into; take another folder for " +
                                        option);
  }
}

void print_json(const Arguments& a, const Sequence& sequence, const TsdfVolume& volume,
                std::size_t points) {
  nlohmann::ordered_json outcome = {
      {"cloud", a.cloud.string()},
      {"points", points},
      {"frames", volume.frames()},
      {"frames_lost", sequence.lost()},
      {"frames_without_pose", sequence.unposed()},
      {"layout", name(sequence.layout())},
      {"poses", sequence.poses_are_estimated() ? "odometry" : "files"},
      {"voxel_size", volume.options().voxel_size},
      {"truncation", volume.options().truncation}};
  if (!a.mesh.empty()) outcome["mesh"] = a.mesh.string();
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::printf("%s\n", outcome.dump(1, ' ', false, replace).c_str());
}

void run(const Arguments& a) {
  check_output("-o", a.cloud, {".ply", ".pcd"});
  if (!a.mesh.empty()) check_output("--mesh", a.mesh, {".ply"});
  if (!a.trajectory.empty()) check_output("--trajectory", a.trajectory, {".log", ".txt"});
  if (!a.trajectory.empty()) {  // before odometry takes minutes
    SequenceOptions wanted = a.depth.options();
    wanted.color = false;
    wanted.poses = PoseSource::None;
    const Sequence listed(a.sequence, wanted);
    check_trajectory_name(a.trajectory, listed.layout());
  }
  std::unique_ptr<TbbLimit> limit;
  if (a.threads > 0) {
    limit = std::make_unique<TbbLimit>(TbbLimit::max_allowed_parallelism, a.threads);
  }
  const Sequence sequence = a.depth.open(a.sequence, a.console);
  if (!a.trajectory.empty()) write_trajectory(sequence, a.trajectory);
  const TsdfVolume volume = fuse(sequence, a.depth.fusion, a.console);
  PointCloud points;
  if (a.mesh.empty()) {
    points = volume.points();
  } else {
    Mesh mesh = volume.mesh();
    write_mesh(mesh, a.mesh);
    a.console.say(a.mesh.string() + ": " + std::to_string(mesh.triangles.size()) + " triangles");
    points = std::move(mesh.vertices);
  }
  write_cloud(points, a.cloud);
  a.console.say(a.cloud.string() + ": " + std::to_string(points.size()) + " points with normals" +
                (points.has_colors() ? " and colours" : ""));
  if (a.console.json) print_json(a, sequence, volume, points.size());
}

}  // namespace

Command add_reconstruct(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("reconstruct", "Fuse an RGB-D sequence into a map");
  command
      ->add_option("SEQUENCE", a->sequence,
                   "Folder: depth.txt, groundtruth.txt, rgb.txt (TUM); depth/, image/, "
                   "trajectory.log (Open3D); or frame-*.depth.png, .pose.txt, .color.* (7-Scenes)")
      ->required();
  command->add_option("-o,--output", a->cloud, "The map's points, .ply or .pcd")
      ->required()
      ->type_name("CLOUD");
  command->add_option("--mesh", a->mesh, "Its surface as triangles, too")->type_name("PLY");
  command
      ->add_option(
          "--trajectory", a->trajectory,
          "The poses that were used, too: *.log as Redwood's trajectory.log, *.txt as TUM's "
          "groundtruth.txt")
      ->type_name("FILE");
  a->depth.declare_camera(*command);
  a->depth.declare_sequence(*command);
  command->add_option("--threads", a->threads, "Threads at most (all); the result is the same")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
