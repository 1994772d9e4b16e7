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
#include "planescope/render.hpp"

namespace planescope::cli {
namespace {

struct Arguments {
  Console console;
  CameraArguments camera;
  std::filesystem::path folder, png;
  std::string layers, background, title;
  int supersample = RenderOptions{}.supersample;
  double point_size = 0;
  bool no_edl = false, no_cull = false;
};

RenderOptions drawing(const Arguments& a) {
  RenderOptions options;
  a.camera.apply(options);
  if (!a.layers.empty()) options.layers = parse_layers("--layers", a.layers);
  if (!a.background.empty()) options.background = parse_color("--background", a.background);
  options.supersample = a.supersample;
  options.point_size = a.point_size;
  options.eye_dome_lighting = !a.no_edl;
  options.cull_front = !a.no_cull;
  options.title = a.title;
  return options;
}

void run(const Arguments& a) {
  if (a.png.extension() != ".png") {
    throw Error(Error::Kind::Usage,
                "-o is `" + a.png.string() + "`; it takes a name that ends in .png");
  }
  render(a.folder, drawing(a), a.png);
  a.console.say(a.png.string());
  if (a.console.json) {
    const nlohmann::json outcome = {{"picture", a.png.string()}};
    std::printf("%s\n",
                outcome.dump(1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  }
}

}  // namespace

Command add_render(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command =
      program.add_subcommand("render", "Draw a stored result, nothing computed again");
  command->add_option("DIR", a->folder, "Result folder of `planescope segment`")->required();
  command->add_option("-o,--output", a->png, "Picture")->required()->type_name("PNG");
  command
      ->add_option("--layers", a->layers,
                   "scene, patches, segments, planes, graph, joined by commas (segments)")
      ->type_name("LAYERS");
  a->camera.declare(*command);
  command->add_option("--background", a->background, "white | black | R,G,B from 0 to 1 (white)")
      ->type_name("COLOR");
  command->add_option("--supersample", a->supersample, "Antialiasing: drawn this many times larger")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command
      ->add_option("--point-size", a->point_size,
                   "Size of a point in pixels; 0: from their spacing, so that surfaces close")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("--title", a->title, "Text at the top left")->type_name("TEXT");
  command->add_flag("--no-edl", a->no_edl, "No eye-dome lighting");
  command->add_flag("--no-cull", a->no_cull,
                    "Keep planes that stand between the camera and the room");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
