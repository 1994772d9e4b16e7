// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/console.hpp"
#include "cli/engine_arguments.hpp"
#include "cli/memory.hpp"
#include "cli/method_arguments.hpp"
#include "cli/truth_arguments.hpp"
#include "cli/values.hpp"
#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/figure.hpp"
#include "planescope/io.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Arguments {
  Console console;
  EngineArguments engine;
  MethodArguments peers;
  TruthArguments counted;
  CameraArguments camera;
  FigureOptions figure;
  LimitArguments limits;
  fs::path scene, png, truth;
  std::string methods = "ransac,lccp,ours";
};

std::string caption(const std::string& method) {
  if (method == "ours") return "Ours";
  std::string name = method;
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

std::string describe(const LabelScores& scores) {
  char text[64];
  std::snprintf(text, sizeof text, "WO %.1f %%   UO %.1f %%", 100 * scores.weighted_overlap,
                100 * scores.overlap);
  return text;
}

std::vector<std::uint32_t> read_truth(const Arguments& a, const PointCloud& cloud) {
  if (a.truth.empty()) return {};
  const PointCloud truth = read_cloud(a.truth, a.limits.read());
  if (truth.size() != cloud.size() || !truth.has_labels()) {
    throw Error(Error::Kind::Input,
                a.truth.string() + ": --truth needs the scene's points with a field `label`");
  }
  return truth.labels;
}

/// The panels, the numbers that they show, and the segmentation that the camera goes by.
struct Content {
  std::vector<FigurePanel> panels;
  Json scores = Json::array();
  Segmentation base;
};

void add_method(const Arguments& a, const std::string& method, const PointCloud& cloud,
                const Options& options, const std::vector<std::uint32_t>& truth, Content& content) {
  Segmentation found = a.peers.run(method, cloud, options, a.console.progress());
  FigurePanel panel{caption(method), "", found.point_label};
  Json line = {{"method", method}, {"segments", found.segments.segments.size()}};
  if (!truth.empty()) {
    const LabelScores scores = score(a.counted, found.point_label, truth).all;
    panel.scores = describe(scores);
    line["weighted_overlap"] = scores.weighted_overlap;
    line["overlap"] = scores.overlap;
  }
  content.panels.push_back(std::move(panel));
  content.scores.push_back(std::move(line));
  // Ours knows planes and patches; what a peer knows is second best.
  const bool better =
      found.method.is_ours() || (!content.base.method.is_ours() && !content.base.method.has_graph);
  if (content.scores.size() == 1 || better) content.base = std::move(found);
}

Content make_content(const Arguments& a, const std::vector<std::string>& methods,
                     const PointCloud& cloud) {
  const std::vector<std::uint32_t> truth = read_truth(a, cloud);
  const Options options = a.engine.resolve(cloud);
  Content content;
  content.panels.push_back({"Scene", "", {}});
  for (const std::string& method : methods) add_method(a, method, cloud, options, truth, content);
  if (truth.empty()) return content;
  const std::vector<std::uint32_t> everywhere(truth.size(), 1);
  content.panels.push_back({"Truth", "", apply_policy(everywhere, truth, a.counted.policy), true});
  return content;
}

void run(Arguments& a) {
  if (a.png.extension() != ".png") {
    throw Error(Error::Kind::Usage,
                "-o is `" + a.png.string() + "`; it takes a name that ends in .png");
  }
  const auto methods = parse_methods("--methods", a.methods);
  a.engine.check();
  a.peers.check();
  a.counted.check();
  a.camera.apply(a.figure.drawing);
  if (!a.camera.size.empty()) a.figure.size = a.figure.drawing.size;
  a.limits.apply();
  const PointCloud cloud = read_cloud(a.scene, a.limits.read());
  const Content content = make_content(a, methods, cloud);
  const fs::path numbers = fs::path(a.png).replace_extension(".json");
  const Json all = {{"scene", a.scene.filename().string()}, {"panels", content.scores}};
  const std::string text = all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  require_memory_for_drawing(a.figure.drawing);
  render_figure(content.base, cloud, content.panels, a.figure, a.png);
  write_whole(numbers, text);
  a.console.say(a.png.string() + "; its numbers in " + numbers.string());
  if (a.console.json) std::fputs(text.c_str(), stdout);
}

}  // namespace

Command add_figure(CLI::App& program) {
  const auto a = std::make_shared<Arguments>();
  CLI::App* command = program.add_subcommand(
      "figure", "Draw a scene and what several methods make of it, as in a paper");
  command->add_option("SCENE", a->scene, "Point cloud: PCD or PLY")->required();
  command->add_option("-o,--output", a->png, "Figure; its numbers go beside it, as .json")
      ->required()
      ->type_name("PNG");
  command->add_option("--methods", a->methods, "Panels after the scene's, in this order")
      ->capture_default_str()
      ->type_name("NAMES");
  command
      ->add_option("--truth", a->truth,
                   "Cloud with the true labels of the same points (may be SCENE): scores, and a "
                   "panel")
      ->type_name("CLOUD");
  command->add_option("--columns", a->figure.columns, "Panels in a row")
      ->check(CLI::Range(1, 26))
      ->capture_default_str();
  command->add_option("--width", a->figure.width_mm, "Width in print [mm]; panels are 4:3")
      ->check(CLI::Range(10.0, 1000.0))
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--dpi", a->figure.dpi, "Resolution in print, which sizes the captions")
      ->check(CLI::Range(72.0, 1200.0))
      ->capture_default_str();
  a->camera.declare(*command);
  command->get_option("--size")->description("Size of the figure in pixels, instead of --width");
  a->counted.declare(*command);
  a->engine.declare(*command);
  a->peers.declare(*command);
  a->limits.declare(*command);
  a->console.declare(*command);
  return {command, [a] { run(*a); }};
}

}  // namespace planescope::cli
