// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engine_arguments.hpp"
#include "cli/memory.hpp"
#include "cli/method_arguments.hpp"
#include "cli/run_info.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/staged_folder.hpp"
#include "cli/values.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"

namespace planescope::cli {
namespace {

using Json = nlohmann::ordered_json;
using TbbLimit = tbb::global_control;

struct Arguments {
  Console console;
  EngineArguments engine;
  MethodArguments peers;
  CameraArguments camera;
  SceneArguments scene;
  std::filesystem::path folder;
  std::string method = "ours";
  bool no_pictures = false;
  std::size_t threads = 0;
  LimitArguments limits;
};

/// A length for people: `7.5 mm`, `2.31 m`.
std::string length(double metres) {
  char text[32];
  const bool small = metres < 0.1;
  std::snprintf(text, sizeof text, small ? "%.3g mm" : "%.3g m", small ? metres * 1000 : metres);
  return text;
}

/// What --preset auto chose, and from what.
std::string describe_choice(const CloudScale& scale, const Options& options) {
  return "preset auto: spacing " + length(scale.spacing) + ", noise " + length(scale.noise) +
         ", extent " + length(scale.extent.x()) + " x " + length(scale.extent.y()) + " x " +
         length(scale.extent.z()) + "; using --voxel-size " +
         get_option(options, "patches.voxel_size") + " --patch-size " +
         get_option(options, "patches.patch_size") + " --patches.range_exponent " +
         get_option(options, "patches.range_exponent") +
         (options.patches.smoothing > 0
              ? " --patches.smoothing " + get_option(options, "patches.smoothing")
              : "") +
         " --planes.sigma " + get_option(options, "planes.sigma") + " --planes.min_area " +
         get_option(options, "planes.min_area");
}

/// Counts of what the method has.
std::string describe_scene(const Segmentation& scene, const PointCloud& cloud) {
  const auto on = std::ranges::count(scene.edges, true, &Edge::on);
  std::string text = std::to_string(cloud.size()) + " points, ";
  if (scene.method.has_graph) text += std::to_string(scene.graph.patches.size()) + " patches, ";
  if (scene.method.has_planes) {
    const std::size_t planes = count_planes(scene.planes, PlaneRole::Support);
    text += std::to_string(planes) + " planes, " + std::to_string(scene.planes.size() - planes) +
            " faces, ";
  }
  if (scene.method.has_graph) {
    text += std::to_string(scene.edges.size()) + " edges (" + std::to_string(on) + " ON, " +
            std::to_string(std::ssize(scene.edges) - on) + " OFF), ";
  }
  text += std::to_string(scene.segments.segments.size()) + " segments";
  if (const std::size_t strays = scene.graph.stray_points; strays > 0)
    text += "; left out " + std::to_string(strays) + " points far away from all others";
  return text;
}

Segmentation compute(const Arguments& a, const PointCloud& cloud) {
  std::optional<CloudScale> scale;  // measured once: a tenth of a second for large maps
  if (!a.console.quiet) scale = measure_scale(cloud);
  const Options options = a.engine.resolve(cloud, scale);
  if (scale) {
    if (a.engine.preset() == "auto") a.console.say(describe_choice(*scale, options));
    const std::string warning = scale_warning(*scale, options);
    if (!warning.empty()) a.console.say("warning: " + warning);
  }
  for (const OptionInfo& info : option_table()) {
    a.console.detail("  " + info.name + " = " + get_option(options, info.name));
  }
  return a.peers.run(a.method, cloud, options, a.console.progress());
}

/// Files of a result folder that a run without pictures does not write.
const std::vector<std::string> kPictures = {"overview.png", "segments.png", "planes.png",
                                            "graph.png"};

std::vector<std::string> result_files() {
  std::vector<std::string> names = {"result.json", "run.json",  "points.pcd",
                                    "patches.vtp", "graph.vtp", "planes.vtp"};
  names.insert(names.end(), kPictures.begin(), kPictures.end());
  return names;
}

/// All outputs, in place only when all of them are whole.
void write(const Arguments& a, const RenderOptions& drawing, const Segmentation& scene,
           const Scene& source, RunInfo& run, const Stopwatch& since_start) {
  const PointCloud& cloud = source.cloud;
  const InputInfo& input = source.input;
  StagedFolder staged(a.folder);
  Stopwatch watch;
  save(scene, cloud, staged.path(), input);
  save_geometry(scene, cloud, staged.path());
  run.write = watch.lap();
  if (!a.no_pictures) require_memory_for_drawing(drawing);
  if (!a.no_pictures) render_pictures(scene, cloud, drawing, staged.path(), input);
  run.pictures = watch.lap();
  run.total = Stopwatch(since_start).lap();
  write_whole(staged.path() / "run.json", run.json());
  std::string names;
  for (const std::string& name : staged.publish("result.json", kPictures)) names += " " + name;
  a.console.say(a.folder.string() + ":" + names);
}

void print_json(const Arguments& a) {
  Json all = {{"folder", a.folder.string()}};
  for (const char* part : {"result", "run"}) {
    std::ifstream in(a.folder / (std::string(part) + ".json"));
    all[part] = Json::parse(in);
  }
  const std::string text = all.dump(1, ' ', false, Json::error_handler_t::replace);
  std::printf("%s\n", text.c_str());
}

void run(Arguments& a) {
  const Stopwatch since_start;
  check_method("--method", a.method);
  a.scene.check();
  a.engine.check();
  a.peers.check();
  RenderOptions drawing;
  a.camera.apply(drawing);
  if (a.folder.empty())
    throw Error(Error::Kind::Usage, "-o is empty; name a folder for the result");
  check_writable(a.folder);
  for (const auto& file : a.scene.files()) refuse_overwriting(file, a.folder, result_files());
  a.limits.apply();
  std::unique_ptr<TbbLimit> limit;
  if (a.threads > 0) {
    limit = std::make_unique<TbbLimit>(TbbLimit::max_allowed_parallelism, a.threads);
  }
  RunInfo info;
  info.threads = TbbLimit::active_value(TbbLimit::max_allowed_parallelism);
  Stopwatch watch;
  const Scene source = a.scene.load(a.console, a.limits.read());
  const PointCloud& cloud = source.cloud;
  info.uncertain = source.uncertain;
  info.odometry = source.odometry;
  const double read_time = watch.lap();
  const Segmentation scene = compute(a, cloud);
  info.stages = scene.times;
  info.stages.read = read_time;
  a.console.say(describe_scene(scene, cloud));
  write(a, drawing, scene, source, info, since_start);
  a.console.detail(info.brief());
  if (a.console.json) print_json(a);
}

}  // namespace

Command add_segment(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand("segment", "Segment a point cloud, and draw it");
  a->scene.declare(*command);
  command->add_option("-o,--output", a->folder, "Folder for the result, made where it is missing")
      ->required()
      ->type_name("DIR");
  command->add_option("--method", a->method, "ours, or a peer: ransac | lccp | cpc (ours)")
      ->type_name("NAME");
  a->engine.declare(*command);
  a->peers.declare(*command);
  a->camera.declare(*command);
  command->add_flag("--no-pictures", a->no_pictures, "Write no PNG (needs no OpenGL)");
  command->add_option("--threads", a->threads, "Threads at most (all); the result is the same")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  a->limits.declare(*command);
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
