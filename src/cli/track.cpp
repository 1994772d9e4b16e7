// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engine_arguments.hpp"
#include "cli/run_info.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/staged_folder.hpp"
#include "cli/values.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"
#include "planescope/track.hpp"

namespace planescope::cli {
namespace {

struct Arguments {
  Console console;
  DepthArguments depth;
  EngineArguments engine;
  CameraArguments camera;
  std::filesystem::path sequence, folder;
  std::uint32_t every = 5;
  double tile = TrackOptions{}.tile_size;
  bool no_pictures = false;
};

/// The tables, as they grow.
struct Tables {
  std::string frames =
      "frame,milliseconds,fusion_milliseconds,pieces,changed,tiles,points,patches,planes,"
      "segments,carried,kept\n";
  std::string events = "frame,event,object,other,points\n";
  double milliseconds = 0, fusion = 0;
  std::size_t carried = 0, kept = 0, events_count = 0;

  void add(const TrackStep& step, double fused) {
    char line[256];
    std::snprintf(line, sizeof line, "%u,%.3f,%.3f,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu\n",
                  step.frame, step.milliseconds, fused, step.pieces, step.changed, step.tiles,
                  step.points, step.patches, step.planes, step.segments, step.carried, step.kept);
    frames += line;
    for (const TrackEvent& event : step.events) {
      std::snprintf(line, sizeof line, "%u,%s,%u,%u,%u\n", event.frame,
                    std::string(name(event.kind)).c_str(), event.object, event.other, event.points);
      events += line;
    }
    milliseconds += step.milliseconds;
    fusion += fused;
    carried += step.carried;
    kept += step.kept;
    events_count += step.events.size();
  }
};

/// Segments of the result and the objects that they are.
std::string objects_csv(const std::vector<std::uint32_t>& objects) {
  std::string text = "label,object\n";
  for (std::size_t s = 0; s < objects.size(); ++s) {
    text += std::to_string(s + 1);
    text += ',';
    text += std::to_string(objects[s]);
    text += '\n';
  }
  return text;
}

/// Fuses frame by frame, and tracks every so many.
void follow(const Arguments& a, const Sequence& sequence, TsdfVolume& volume, MapTracker& tracker,
            Tables& tables) {
  const Progress progress = a.console.progress();
  Stopwatch watch;
  double fused = 0;
  std::uint32_t since = 0;
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (progress) progress("tracking", double(i) / double(sequence.size()));
    const Frame frame = sequence.read(i);
    watch.lap();
    volume.integrate(frame.depth, frame.color, sequence.camera(), frame.info.pose);
    const bool last = i + 1 == sequence.size();
    if (!last && (i + 1) % a.every != 0) {
      fused += watch.lap();
      continue;
    }
    // The last step takes every change, however little: the result is of the whole map.
    const std::vector<SurfacePiece> pieces = changed_pieces(volume, last ? 0 : since);
    fused += watch.lap();
    tables.add(last ? tracker.update_exactly(frame.info.number, pieces)
                    : tracker.update(frame.info.number, pieces),
               fused);
    fused = 0;
    since = volume.frames();
  }
  if (progress) progress("tracking", 1);
}

void write(const Arguments& a, const PointCloud& map, const TrackResult& result,
           const Tables& tables, const InputInfo& input) {
  StagedFolder staged(a.folder);
  save(result.scene, map, staged.path(), input);
  save_geometry(result.scene, map, staged.path());
  write_whole(staged.path() / "frames.csv", tables.frames);
  write_whole(staged.path() / "events.csv", tables.events);
  write_whole(staged.path() / "objects.csv", objects_csv(result.objects));
  if (!a.no_pictures) {
    RenderOptions drawing;
    a.camera.apply(drawing);
    render_pictures(result.scene, map, drawing, staged.path(), input);
  }
  staged.publish("result.json", {"overview.png", "segments.png", "planes.png", "graph.png"});
}

void run(Arguments& a) {
  a.engine.check();
  RenderOptions drawing;
  a.camera.apply(drawing);
  check_writable(a.folder);
  if (a.engine.preset() == "auto") {
    throw Error(Error::Kind::Usage,
                "--preset is `auto`; a map that grows has no scale to derive it from: --preset "
                "room, or tabletop");
  }
  const Sequence sequence = a.depth.open(a.sequence, a.console);
  TsdfVolume volume(a.depth.fusion);
  TrackOptions options;
  options.engine = a.engine.resolve({});
  options.tile_size = a.tile;
  MapTracker tracker(options);
  Tables tables;
  follow(a, sequence, volume, tracker, tables);
  if (tracker.scene().graph.patches.empty()) volume.points();  // throws: says why
  const TrackResult result = tracker.finish(sequence.info(sequence.size() - 1).number);
  PointCloud map = tracker.map();
  map.up = sequence.up();
  write(a, map, result, tables, {a.sequence.filename().string(), sequence.hash()});
  char text[256];
  std::snprintf(
      text, sizeof text,
      "%zu frames; tracking %.1f ms a frame, the whole at once %.1f, fusion %.1f a frame; "
      "%zu events; %.2f %% of places keep their object from step to step",
      sequence.size(), tables.milliseconds / double(sequence.size()), result.step.milliseconds,
      tables.fusion / double(sequence.size()), tables.events_count,
      100.0 * double(tables.kept) / double(std::max<std::size_t>(1, tables.carried)));
  a.console.say(text);
  a.console.say(a.folder.string() + ": " + std::to_string(tracker.map().size()) + " points, " +
                std::to_string(result.scene.planes.size()) + " planes, " +
                std::to_string(result.scene.segments.segments.size()) +
                " segments; frames.csv, events.csv, objects.csv");
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
  command->add_option("--every", a->every, "Segment after every so many frames")
      ->check(CLI::Range(1u, 100'000u))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--tile", a->tile, "Edge of the cubes that are patched by themselves [m]")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str()
      ->type_name("M");
  a->engine.declare(*command);
  a->depth.declare_camera(*command);
  a->depth.declare_sequence(*command);
  a->camera.declare(*command);
  command->add_flag("--no-pictures", a->no_pictures, "Write no PNG (needs no OpenGL)");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
