// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/values.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"
#include "planescope/synthesize.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  Console console;
  SynthesisOptions options;
  fs::path cloud;
  std::string offset;
  std::uint32_t sequence = 0;
  bool ascii = false;
};

void print_json(const SynthesizedScene& scene, const fs::path& cloud, const fs::path& truth) {
  const nlohmann::ordered_json outcome = {{"cloud", cloud.string()},
                                          {"truth", truth.string()},
                                          {"points", scene.cloud.size()},
                                          {"objects", scene.objects},
                                          {"planes", scene.planes.size()}};
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  std::printf("%s\n", outcome.dump(1, ' ', false, replace).c_str());
}

/// The room as depth images with poses; what is true of it goes beside them.
void write_frames(const Arguments& a) {
  if (a.cloud.has_extension()) {
    throw Error(Error::Kind::Usage,
                "-o is `" + a.cloud.string() + "`; with --sequence it takes a folder's name");
  }
  const SynthesizedScene scene =
      write_sequence(a.options, a.sequence, a.cloud, a.console.progress());
  const fs::path cloud = a.cloud / "truth.ply", truth = a.cloud / "truth.json";
  write_cloud(scene.cloud, cloud);
  write_truth(scene, truth);
  a.console.say(a.cloud.string() + ": " + std::to_string(a.sequence) + " frames of " +
                std::to_string(scene.objects.size()) + " objects; truth in " + cloud.string() +
                " and " + truth.string());
  if (a.console.json) print_json(scene, cloud, truth);
}

void run(Arguments& a) {
  if (!a.offset.empty()) a.options.offset = parse_vector("--offset", a.offset);
  if (a.sequence > 0) return write_frames(a);
  if (a.cloud.extension() != ".pcd" && a.cloud.extension() != ".ply") {
    throw Error(Error::Kind::Usage, "-o is `" + a.cloud.string() + "`; it takes *.pcd or *.ply");
  }
  const SynthesizedScene scene = synthesize(a.options);
  const fs::path truth = fs::path(a.cloud).replace_extension(".truth.json");
  write_cloud(scene.cloud, a.cloud, a.ascii ? CloudEncoding::Ascii : CloudEncoding::Binary);
  write_truth(scene, truth);
  a.console.say(a.cloud.string() + ": " + std::to_string(scene.cloud.size()) + " points of " +
                std::to_string(scene.objects.size()) + " objects; truth in " + truth.string());
  if (a.console.json) print_json(scene, a.cloud, truth);
}

}  // namespace

Command add_synthesize(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("synthesize", "Make a furnished room with ground truth");
  command
      ->add_option("-o,--output", a->cloud,
                   "Point cloud, .pcd or .ply; what is true of it goes beside it, as .truth.json")
      ->required()
      ->type_name("CLOUD");
  auto* points =
      command->add_option("--points", a->options.points, "Sampled evenly: this many points")
          ->capture_default_str();
  command->add_option("--views", a->options.views, "Seen by this many depth cameras instead")
      ->check(CLI::PositiveNumber)
      ->excludes(points);
  command
      ->add_option("--sequence", a->sequence,
                   "Instead of a cloud, this many RGB-D frames with poses, carried through the "
                   "room, into the folder -o; --points are those of its truth.ply")
      ->check(CLI::Range(1u, kMostFrames))
      ->excludes("--views")
      ->type_name("N");
  command->add_option("--random-seed", a->options.random_seed, "Another seed, another room")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      ->add_option("--noise", a->options.noise,
                   "Standard deviation of the noise [m]; with --views: at 1 m, growing by z^2")
      ->capture_default_str();
  command->add_flag("--ceiling", a->options.ceiling, "Close the room");
  command->add_flag("--normals", a->options.normals, "Store normals too");
  command->add_option("--offset", a->offset, "Moves the room, as map coordinates do [m]")
      ->type_name("X,Y,Z");
  command->add_flag("--ascii", a->ascii, "Write text instead of binary");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
