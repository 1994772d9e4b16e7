// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/memory.hpp"
#include "cli/picture_arguments.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"

namespace planescope::cli {
namespace {

struct Arguments {
  Console console;
  PictureArguments picture;
  std::filesystem::path folder, png, save_camera;
  int orbit = 0;
};

/// How well readers tell the colours of touching segments apart.
nlohmann::ordered_json colors_json(const Arguments& a) {
  const ColorDifferences least = color_differences(a.folder, a.picture.options());
  return {{"touching_pairs", least.pairs},  {"normal", least.normal},
          {"protanopia", least.protanopia}, {"deuteranopia", least.deuteranopia},
          {"tritanopia", least.tritanopia}, {"grey", least.grey}};
}

void run(const Arguments& a) {
  if (a.png.extension() != ".png") {
    throw Error(Error::Kind::Usage,
                "-o is `" + a.png.string() + "`; it takes a name that ends in .png");
  }
  const RenderOptions options = a.picture.options();
  require_memory_for_drawing(options);
  nlohmann::ordered_json outcome = {{"picture", a.png.string()}};
  if (a.orbit > 0) {
    render_orbit(a.folder, options, a.orbit, a.png);
    outcome["frames"] = a.orbit;
  } else {
    const Camera camera = render(a.folder, options, a.png);
    if (!a.save_camera.empty()) write_camera(camera, a.save_camera);
    outcome["camera"] = nlohmann::ordered_json::parse(camera_json(camera));
    if (a.console.json) outcome["segment_colors"] = colors_json(a);
  }
  a.console.say(a.png.string());
  if (a.console.json) {
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
  a->picture.declare(*command);
  auto* save = command->add_option("--save-camera", a->save_camera, "Keep the camera in this file");
  save->type_name("JSON");
  command
      ->add_option("--orbit", a->orbit,
                   "Once around the scene in this many frames: an animated PNG of ten seconds")
      ->check(CLI::Range(2, 360))
      ->excludes(save)
      ->type_name("FRAMES");
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
