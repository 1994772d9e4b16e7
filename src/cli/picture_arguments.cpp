// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/picture_arguments.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "planescope/error.hpp"
#include "planescope/io.hpp"

namespace planescope::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& expected) {
  throw Error(Error::Kind::Usage, option + " is `" + text + "`; it takes " + expected);
}

template <class Value, std::size_t N>
Value named(const std::array<std::pair<const char*, Value>, N>& names, const std::string& option,
            const std::string& text) {
  std::string all;
  for (const auto& [name, value] : names) {
    if (text == name) return value;
    all += (all.empty() ? "" : " | ") + std::string(name);
  }
  refuse(option, text, all);
}

ColorBy parse_color_by(const std::string& text) {
  static constexpr std::array<std::pair<const char*, ColorBy>, 8> kNames = {
      {{"segment", ColorBy::Segment},
       {"plane", ColorBy::Plane},
       {"patch", ColorBy::Patch},
       {"normal", ColorBy::Normal},
       {"curvature", ColorBy::Curvature},
       {"truth", ColorBy::Truth},
       {"rgb", ColorBy::Rgb},
       {"height", ColorBy::Height}}};
  return named(kNames, "--color-by", text);
}

Palette parse_palette(const std::string& text) {
  static constexpr std::array<std::pair<const char*, Palette>, 4> kNames = {
      {{"standard", Palette::Standard},
       {"vivid", Palette::Vivid},
       {"pastel", Palette::Pastel},
       {"grey", Palette::Grey}}};
  return named(kNames, "--palette", text);
}

/// A whole number of at least `least`, or nothing.
std::optional<std::int32_t> whole(const std::string& text, std::int32_t least) {
  std::int32_t value = 0;
  const auto [stop, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = failure == std::errc() && stop == text.data() + text.size() && value >= least;
  return good ? std::optional(value) : std::nullopt;
}

/// `auto`, `none`, or numbers of planes.
void parse_cutaway(const std::string& text, RenderOptions& options) {
  if (text == "auto") return;
  if (text == "none") {
    options.cull_front = false;
    return;
  }
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const auto plane = whole(text.substr(begin, end - begin), 0);
    if (!plane) refuse("--cutaway", text, "auto, none, or numbers of planes such as 1,3");
    options.cutaway.push_back(*plane);
    begin = end + 1;
  }
}

}  // namespace

void PictureArguments::declare(CLI::App& command) {
  command
      .add_option("--layers", layers_,
                  "scene, patches, segments, planes, graph, joined by commas (segments)")
      ->type_name("LAYERS");
  view_.declare(command);
  declare_camera(command);
  declare_colors(command);
  declare_annotation(command);
}

void PictureArguments::declare_camera(CLI::App& command) {
  command.add_option("--azimuth", azimuth_, "Where the camera stands, from the scene's front")
      ->check(CLI::Range(-360.0, 360.0))
      ->type_name("DEG");
  command.add_option("--elevation", elevation_, "How high it stands over the horizon")
      ->check(CLI::Range(-90.0, 90.0))
      ->type_name("DEG");
  command.add_option("--roll", drawn_.camera.roll, "Turn of the camera about its view")
      ->check(CLI::Range(-360.0, 360.0))
      ->type_name("DEG");
  command.add_option("--zoom", drawn_.camera.zoom, "This many times as large as what fits")
      ->check(CLI::Range(0.01, 100.0))
      ->type_name("FACTOR");
  command.add_flag("--ortho", drawn_.camera.parallel, "Parallel projection, not perspective");
  command.add_option("--focal", focal_, "What stands in the middle of the picture")
      ->type_name("X,Y,Z");
  command
      .add_option("--fit", fit_,
                  "Frame one segment, as segment:K; or take the camera that a picture of another "
                  "result folder has")
      ->type_name("DIR|segment:K");
  command.add_option("--camera", camera_, "Camera of --save-camera, instead of all of these")
      ->type_name("JSON");
  command
      .add_option("--cutaway", cutaway_,
                  "Walls before the camera: auto, none, or planes to leave out (auto)")
      ->type_name("auto|none|PLANES");
  command.add_flag("--no-cull", no_cull_, "The same as --cutaway none");
}

void PictureArguments::declare_colors(CLI::App& command) {
  command
      .add_option("--color-by", color_by_,
                  "segment | plane | patch | normal | curvature | truth | rgb | height, instead of "
                  "what the layers say")
      ->type_name("WHAT");
  command.add_option("--truth", truth_, "Cloud with the true labels, for --color-by truth")
      ->type_name("CLOUD");
  command
      .add_option("--palette", palette_,
                  "standard (calm planes, vivid objects) | vivid | pastel | grey")
      ->type_name("NAME");
  command
      .add_option("--colors-of", colors_of_,
                  "Result folder of the same cloud: the same segments get the same colours")
      ->type_name("DIR");
  command.add_option("--background", background_, "white | black | R,G,B from 0 to 1 (white)")
      ->type_name("COLOR");
  command.add_flag("--transparent", drawn_.transparent, "No background: PNG with alpha");
  command.add_flag("--no-edl", no_edl_, "No eye-dome lighting");
  command
      .add_option("--supersample", drawn_.supersample, "Antialiasing: drawn this many times larger")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command
      .add_option("--point-size", drawn_.point_size,
                  "Size of a point in pixels; 0: from their spacing, so that surfaces close")
      ->check(CLI::Range(0.0, 100.0));
  command
      .add_option("--thin-from", drawn_.thin_from,
                  "From this many points on, only the nearest one in each pixel is drawn")
      ->capture_default_str()
      ->type_name("POINTS");
  command.add_option("--dpi", drawn_.dpi, "Resolution that the PNG says, for print")
      ->check(CLI::Range(1.0, 10000.0))
      ->type_name("DPI");
}

void PictureArguments::declare_annotation(CLI::App& command) {
  AnnotationOptions& annotation = drawn_.annotation;
  command.add_option("--title", annotation.title, "Text at the top left")->type_name("TEXT");
  command.add_flag("--legend", annotation.legend, "What the colours mean");
  command.add_flag("--labels", annotation.labels, "Numbers of segments at their centroids");
  command.add_flag("--scale-bar", annotation.scale_bar, "A length in metres");
  command.add_flag("--axes", annotation.axes, "Directions of x, y and z");
}

void PictureArguments::apply_camera(CameraOptions& camera) const {
  camera.azimuth = azimuth_;
  camera.elevation = elevation_;
  if (!focal_.empty()) camera.focal = parse_vector("--focal", focal_);
  if (!camera_.empty()) camera.fixed = read_camera(camera_);
  if (fit_.empty()) return;
  const std::string prefix = "segment:";
  if (!fit_.starts_with(prefix)) {
    camera.fit = fit_;
    return;
  }
  const auto label = whole(fit_.substr(prefix.size()), 1);
  if (!label) refuse("--fit", fit_, "a result folder, or segment:K with K from 1");
  camera.fit_segment = static_cast<std::uint32_t>(*label);
}

RenderOptions PictureArguments::options() const {
  RenderOptions options = drawn_;
  view_.apply(options);
  apply_camera(options.camera);
  if (!layers_.empty()) options.layers = parse_layers("--layers", layers_);
  if (!background_.empty()) options.background = parse_color("--background", background_);
  if (!color_by_.empty()) options.color_by = parse_color_by(color_by_);
  if (!palette_.empty()) options.palette = parse_palette(palette_);
  if (!colors_of_.empty()) options.colors_of = colors_of_;
  options.eye_dome_lighting = !no_edl_;
  options.cull_front = !no_cull_;
  if (!cutaway_.empty()) parse_cutaway(cutaway_, options);
  if (options.color_by == ColorBy::Truth && truth_.empty())
    throw Error(Error::Kind::Usage, "--color-by truth needs --truth CLOUD");
  if (truth_.empty()) return options;
  options.truth = read_cloud(truth_).labels;
  if (options.truth.empty())
    throw Error(Error::Kind::Input,
                truth_.string() + ": has no field `label`; name a cloud that has one");
  return options;
}

}  // namespace planescope::cli
