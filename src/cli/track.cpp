// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engine_arguments.hpp"
#include "cli/run_info.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/staged_folder.hpp"
#include "cli/track_pictures.hpp"
#include "cli/track_snapshot.hpp"
#include "cli/track_tables.hpp"
#include "cli/values.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"
#include "planescope/track.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  Console console;
  DepthArguments depth;
  EngineArguments engine;
  CameraArguments camera;
  fs::path sequence, folder, resume;
  std::uint32_t step = 5, every = 0;
  double tile = TrackOptions{}.tile_size;
  std::string animate;
  bool no_pictures = false;
};

/// What --preset auto goes by: the map that the first frames make. Its scale is the fusion voxel's,
/// which later frames do not change.
Options resolve_engine(const Arguments& a, const Sequence& sequence) {
  if (a.engine.preset() != "auto") return a.engine.resolve({});
  constexpr std::size_t kFirst = 10;
  TsdfVolume volume(a.depth.fusion);
  const std::size_t count = std::min(kFirst, sequence.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Frame frame = sequence.read(i);
    volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
  }
  Options options = a.engine.resolve(volume.points());
  options.patches.range_exponent = 0;  // the first frames may look like a scan from one place
  options.patches.smoothing = 0;       // it is fused
  a.console.say("preset auto, from the map of the first " + std::to_string(count) +
                " frames: --voxel-size " + get_option(options, "patches.voxel_size") +
                " --patch-size " + get_option(options, "patches.patch_size") + " --planes.sigma " +
                get_option(options, "planes.sigma") + " --planes.min_area " +
                get_option(options, "planes.min_area"));
  return options;
}

/// Spread over `step` frames each: over all of them, 3.5 % of the map are patched a frame at most.
TrackOptions track_options(const Arguments& a, const Sequence& sequence) {
  TrackOptions options;
  options.engine = resolve_engine(a, sequence);
  options.tile_size = a.tile;
  options.interval = a.step;
  const std::uint32_t patching = std::max(a.step, 4U) - 3;  // the others find planes and edges
  const double frames = std::max(a.step - 1, 1U) / static_cast<double>(patching);
  options.share = 0.035 * frames;
  options.least_points = static_cast<std::uint32_t>(8000 * frames);
  return options;
}

/// True if a camera does not move like that within a frame or a few: tracking was lost, and found
/// its place again, or is wrong from here on.
bool jumps(const FrameInfo& before, const FrameInfo& now) {
  constexpr double kFar = 0.5, kTurn = 30 * std::numbers::pi / 180;  // [m], [rad] a frame
  const double frames = now.number - before.number;
  const double moved = (now.pose.translation() - before.pose.translation()).norm();
  const Eigen::AngleAxisd turn(before.pose.linear().transpose() * now.pose.linear());
  return moved > kFar * frames || turn.angle() > kTurn * frames;
}

TrackResult finish(const TrackRun& run, const Sequence& sequence) {
  const std::vector<SurfacePiece> all = changed_pieces(run.volume, 0);
  const auto has_points = [](const SurfacePiece& piece) { return piece.points.size() > 0; };
  if (std::ranges::none_of(all, has_points)) run.volume.points();  // throws: says why
  TrackResult result = run.tracker.finish(sequence.info(run.done - 1).number, all);
  result.map.up = sequence.up();
  return result;
}

/// A result folder's files, but for pictures and run.json.
void save_result(const TrackResult& result, const TrackTables& tables, const InputInfo& input,
                 const fs::path& folder) {
  save(result.scene, result.map, folder, input);
  save_geometry(result.scene, result.map, folder);
  tables.write(folder);
  write_whole(folder / "objects.csv", objects_csv(result.objects));
}

/// The result so far, and where the run stands, as a folder of its own.
void write_snapshot_folder(const Arguments& a, const TrackRun& run, const Sequence& sequence) {
  char name[32];
  std::snprintf(name, sizeof name, "%06u", sequence.info(run.done - 1).number);
  const fs::path place = a.folder / "snapshots" / name;
  StagedFolder staged(place);
  const TrackResult result = finish(run, sequence);
  TrackTables tables = run.tables;
  tables.close(result.step);
  save_result(result, tables, {a.sequence.filename().string(), {}}, staged.path());
  write_snapshot(run, sequence, staged.path());
  staged.publish("result.json", {});
  a.console.detail(place.string() + ": " + std::to_string(run.done) + " frames");
}

/// Fuses and tracks one frame.
void advance(const Sequence& sequence, const TrackCamera& camera, TrackRun& run) {
  const Frame frame = sequence.read(run.done);
  if (run.done > 0 && jumps(sequence.info(run.done - 1), frame.info)) {
    run.tables.add_jump(frame.info.number);
  }
  Stopwatch watch;
  const std::uint32_t since = run.volume.frames();
  run.volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
  const std::vector<SurfacePiece> pieces = changed_pieces(run.volume, since);
  const double fused = watch.lap();
  const TrackStep step = run.tracker.update(frame.info.number, pieces);
  run.tables.add(step, fused);
  camera.take(run.tracker, step, frame.info, run.pictures);
  ++run.done;
}

void follow(const Arguments& a, const Sequence& sequence, const TrackCamera& camera,
            TrackRun& run) {
  const Progress progress = a.console.progress();
  while (run.done < sequence.size()) {
    if (progress) progress("tracking", double(run.done) / double(sequence.size()));
    advance(sequence, camera, run);
    if (a.every > 0 && run.done % a.every == 0) write_snapshot_folder(a, run, sequence);
  }
  if (progress) progress("tracking", 1);
}

void write(const Arguments& a, const TrackResult& result, const TrackRun& tracked,
           const InputInfo& input, RunInfo& run, const Stopwatch& since_start) {
  StagedFolder staged(a.folder);
  Stopwatch watch;
  save_result(result, tracked.tables, input, staged.path());
  run.write = watch.lap();
  if (!a.no_pictures) {
    write_track_pictures(tracked.pictures, tracked.tables, staged.path());
    RenderOptions drawing;
    a.camera.apply(drawing);
    render_pictures(result.scene, result.map, drawing, staged.path(), input);
  }
  run.pictures = watch.lap();
  run.total = Stopwatch(since_start).lap();
  write_whole(staged.path() / "run.json", run.json());
  staged.publish("result.json", {"overview.png", "segments.png", "planes.png", "graph.png",
                                 "growth.png", "track.png"});
}

void report(const Arguments& a, const Sequence& sequence, const TrackTables& tables,
            const TrackResult& result) {
  if (tables.jumps() > 0) {
    a.console.say("warning: the pose jumps " + std::to_string(tables.jumps()) +
                  " times by more than 0.5 m or 30 degrees a frame (`jump` in events.csv); such "
                  "frames are fused where their poses say. If tracking was lost there, leave them "
                  "out with --frames");
  }
  a.console.say(std::to_string(sequence.size()) + " frames; " + tables.summary());
  a.console.say(a.folder.string() + ": " + std::to_string(result.map.size()) + " points, " +
                std::to_string(result.scene.planes.size()) + " planes, " +
                std::to_string(result.scene.segments.segments.size()) +
                " segments; frames.csv, times.csv, events.csv, objects.csv");
}

void run(Arguments& a) {
  const Stopwatch since_start;
  a.engine.check();
  RenderOptions drawing;
  a.camera.apply(drawing);
  check_writable(a.folder);
  const Sequence sequence = a.depth.open(a.sequence, a.console);
  const TrackOptions options = track_options(a, sequence);
  TrackRun run = a.resume.empty() ? TrackRun{TsdfVolume(a.depth.fusion), MapTracker(options), {}, 0}
                                  : read_snapshot(a.resume, sequence, options, a.depth.fusion);
  if (!a.resume.empty()) a.console.say("going on after " + std::to_string(run.done) + " frames");
  follow(a, sequence, TrackCamera(a.animate, drawing, sequence, options), run);
  const TrackResult result = finish(run, sequence);
  run.tables.close(result.step);
  RunInfo info;
  info.stages = result.scene.times;
  info.odometry = sequence.poses_are_estimated();
  info.threads = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  write(a, result, run, {a.sequence.filename().string(), sequence.hash()}, info, since_start);
  report(a, sequence, run.tables, result);
}

}  // namespace

Command add_track(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "track", "Segment an RGB-D sequence while it grows: objects keep their numbers");
  command->add_option("SEQUENCE", a->sequence, "Folder, as of reconstruct")->required();
  command->add_option("-o,--output", a->folder, "Folder for the result, made where it is missing")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--step", a->step,
                   "Segment after every so many frames; the work is spread over them")
      ->check(CLI::Range(1u, 100'000u))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--every", a->every,
                   "After every so many frames, write the result so far into DIR/snapshots (0: do "
                   "not)")
      ->check(CLI::Range(0u, 100'000u))
      ->type_name("N");
  command
      ->add_option("--resume", a->resume,
                   "Go on from such a snapshot; the other options must be those of its run")
      ->type_name("SNAPSHOT");
  command
      ->add_option("--animate", a->animate,
                   "The growing map as an animated PNG, a picture after each --step: from one "
                   "place (steady), or as the camera moves (sensor)")
      ->check(CLI::IsMember({"steady", "sensor"}))
      ->type_name("HOW");
  command->add_option("--tile", a->tile, "Edge of the cubes that are patched by themselves [m]")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str()
      ->type_name("M");
  a->engine.declare(*command);
  a->depth.declare_camera(*command);
  a->depth.declare_sequence(*command);
  a->camera.declare(*command);
  command->add_flag("--no-pictures", a->no_pictures, "Write no PNG (needs no OpenGL)")
      ->excludes("--animate");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
