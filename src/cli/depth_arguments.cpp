// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include "cli/console.hpp"
#include "cli/odometry.hpp"
#include "cli/scene_arguments.hpp"
#include "cli/values.hpp"
#include "io/numbers.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& text, const char* takes) {
  throw Error(Error::Kind::Usage, option + " is `" + text + "`; it takes " + takes);
}

/// Numbers, a known name, or a file.
void parse_camera(const std::string& text, SequenceOptions& options) {
  const std::vector<std::string> names = camera_names();
  if (std::ranges::find(names, text) != names.end()) {
    options.lens = named_camera(text);
  } else if (text.find(',') != std::string::npos) {
    const std::array<double, 4> k = parse_intrinsics("--intrinsics", text);
    options.lens =
        PinholeCamera{.width = 0, .height = 0, .fx = k[0], .fy = k[1], .cx = k[2], .cy = k[3]};
  } else if (std::filesystem::exists(text)) {
    const CameraFile camera = read_camera_file(text);
    options.lens = camera.lens;
    if (!options.depth_scale) options.depth_scale = camera.depth_scale;
  } else {
    refuse("--intrinsics", text,
           "FX,FY,CX,CY, a file, or one of primesense | tum_fr1 | tum_fr2 | tum_fr3 | 7scenes | "
           "icl_nuim");
  }
}

/// `FIRST:LAST:STEP`; parts may be empty, and the last ones missing.
void parse_frames(const std::string& text, SequenceOptions& options) {
  const std::array<std::uint32_t*, 3> parts = {&options.first, &options.last, &options.step};
  std::size_t begin = 0;
  for (std::size_t part = 0; begin <= text.size(); ++part) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    const auto word = std::string_view(text).substr(begin, end - begin);
    const auto number = io::parse_word<std::uint32_t>(word);
    if (part >= 3 || (!word.empty() && !number)) {
      refuse("--frames", text, "FIRST:LAST:STEP, whole numbers from 0");
    }
    if (number) *parts[part] = *number;
    begin = end + 1;
  }
  if (options.step < 1 || options.first > options.last) {
    refuse("--frames", text, "FIRST:LAST:STEP, FIRST up to LAST, STEP at least 1");
  }
}

std::string count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

/// 1000, 6553.5: no more digits than it has.
std::string units(double scale) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", scale);
  return text;
}

}  // namespace

void DepthArguments::declare_camera(CLI::App& command) {
  command
      .add_option("--intrinsics", intrinsics_,
                  "FX,FY,CX,CY [pixel], a file (Open3D's JSON, or `width height fx fy cx cy "
                  "[scale]`), or primesense | tum_fr1 | tum_fr2 | tum_fr3 | 7scenes | icl_nuim")
      ->type_name("CAMERA")
      ->group(kGroup);
  command
      .add_option("--depth-scale", given_.depth_scale,
                  "Stored units a metre (the sequence's own; else 1000, TUM 5000)")
      ->check(CLI::Range(1e-3, 1e6))
      ->type_name("UNITS")
      ->group(kGroup);
  command.add_option("--min-depth", given_.min_depth, "Nearer returns are left out [m]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str()
      ->type_name("M")
      ->group(kGroup);
  command.add_option("--max-depth", max_depth_, "Farther returns are left out [m] (sequences: 4)")
      ->check(CLI::Range(0.0, 1e9))
      ->type_name("M")
      ->group(kGroup);
  command.add_flag("--no-color", no_color_, "Colour images are not read")->group(kGroup);
}

void DepthArguments::declare_sequence(CLI::App& command) {
  command.add_option("--frames", frames_, "FIRST:LAST:STEP, from 0, LAST included (all)")
      ->type_name("RANGE")
      ->group(kGroup);
  command.add_option("--layout", layout_, "tum | redwood | frames (by the files that are there)")
      ->type_name("NAME")
      ->group(kGroup);
  command
      .add_flag(
          "--odometry", odometry_,
          "Estimate the poses, whatever the sequence's files say (done anyway where it has none)")
      ->group(kGroup);
  command.add_option("--fusion-voxel", fusion.voxel_size, "Voxels of the fusion [m]")
      ->check(CLI::Range(0.001, 1.0))
      ->capture_default_str()
      ->type_name("M")
      ->group(kGroup);
  command
      .add_option("--truncation", fusion.truncation,
                  "Distances are fused up to this [m] (four voxels)")
      ->check(CLI::Range(0.002, 100.0))
      ->type_name("M")
      ->group(kGroup);
  command
      .add_option("--min-observations", fusion.min_observations,
                  "Surface that fewer frames saw is left out (3; of less than 10 frames 1)")
      ->check(CLI::Range(1, 255))
      ->type_name("N")
      ->group(kGroup);
}

SequenceOptions DepthArguments::options() const {
  SequenceOptions options = given_;
  options.color = !no_color_;
  if (max_depth_) options.max_depth = *max_depth_;
  if (!intrinsics_.empty()) parse_camera(intrinsics_, options);
  if (!frames_.empty()) parse_frames(frames_, options);
  if (options.min_depth >= options.max_depth) {
    throw Error(Error::Kind::Usage, "--max-depth is not more than --min-depth");
  }
  if (layout_.empty()) return options;
  for (const auto layout : {SequenceLayout::Tum, SequenceLayout::Redwood, SequenceLayout::Frames}) {
    if (layout_ == name(layout)) options.layout = layout;
  }
  if (!options.layout) refuse("--layout", layout_, "tum | redwood | frames");
  return options;
}

Sequence DepthArguments::open(const std::filesystem::path& folder, const Console& console) const {
  constexpr double kSurest = 4;  // [m]
  SequenceOptions wanted = options();
  if (!max_depth_) wanted.max_depth = std::max(kSurest, 2 * wanted.min_depth);
  wanted.poses = odometry_ ? PoseSource::None : PoseSource::FilesIfThere;
  Sequence sequence(folder, wanted);
  std::string text = folder.string() + ": " + count(sequence.size(), "frame") + ", layout " +
                     std::string(name(sequence.layout())) +
                     ", camera: " + sequence.camera_source() + ", " +
                     units(sequence.camera().depth_scale) + " units a metre";
  if (sequence.lost() > 0) {
    text += "; " + count(sequence.lost(), "frame") + " left out: tracking lost";
  }
  if (sequence.unposed() > 0) {
    text += "; " + count(sequence.unposed(), "frame") + " left out: no pose";
  }
  console.say(text);
  if (!sequence.has_poses()) give_poses(sequence, console);
  return sequence;
}

}  // namespace planescope::cli
