// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/scene_arguments.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <utility>

#include "cli/console.hpp"
#include "cli/run_info.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"

namespace planescope::cli {
namespace {

std::string size_text(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// Of the camera that was given, or PrimeSense, with the images' size.
DepthCamera camera_of(const SequenceOptions& options, const DepthImage& depth,
                      const std::filesystem::path& file) {
  DepthCamera camera;
  camera.lens = options.lens.value_or(named_camera("primesense"));
  camera.depth_scale = options.depth_scale.value_or(1000);
  camera.min_depth = options.min_depth;
  camera.max_depth = options.max_depth;
  if (camera.lens.width == 0) {
    camera.lens.width = depth.width;
    camera.lens.height = depth.height;
  }
  if (camera.lens.width != depth.width || camera.lens.height != depth.height) {
    throw Error(Error::Kind::Input, file.string() + ": is " + size_text(depth.width, depth.height) +
                                        " pixels, the camera " +
                                        size_text(camera.lens.width, camera.lens.height) +
                                        "; expected the same size, or --intrinsics FX,FY,CX,CY");
  }
  return camera;
}

}  // namespace

void SceneArguments::declare(CLI::App& command) {
  command.add_option("SCENE", scene_,
                     "Point cloud: PCD or PLY; or a folder with an RGB-D sequence");
  command
      .add_option("--min-confidence", min_confidence_,
                  "Leave out points with a lower `confidence`, of surfel maps that have it")
      ->check(CLI::Number)
      ->type_name("C");
  command.add_option("--depth", depth_, "A single view instead: depth image, PNG of 16-bit grey")
      ->type_name("PNG")
      ->group(DepthArguments::kGroup);
  command.add_option("--color", color_, "Its colours: PNG or JPEG of the same size")
      ->type_name("IMAGE")
      ->group(DepthArguments::kGroup);
  camera_.declare_camera(command);
  camera_.declare_sequence(command);
}

void SceneArguments::check() const {
  if (scene_.empty() == depth_.empty()) {
    throw Error(Error::Kind::Usage, scene_.empty()
                                        ? "SCENE is required: a point cloud, or --depth PNG"
                                        : "SCENE and --depth exclude each other");
  }
  if (depth_.empty() && !color_.empty()) {
    throw Error(Error::Kind::Usage, "--color belongs to --depth");
  }
  if (min_confidence_ && (scene_.empty() || std::filesystem::is_directory(scene_))) {
    throw Error(Error::Kind::Usage, "--min-confidence belongs to a point cloud's file");
  }
  if (min_confidence_ && !std::isfinite(*min_confidence_)) {
    throw Error(Error::Kind::Usage, "--min-confidence is no finite number");
  }
  camera_.options();
}

Scene SceneArguments::load(const Console& console, const ReadLimits& limits) const {
  if (!depth_.empty()) return load_view(console);
  if (std::filesystem::is_directory(scene_)) return load_sequence(console);
  return load_cloud(console, limits);
}

Scene SceneArguments::load_cloud(const Console& console, const ReadLimits& limits) const {
  Scene scene{read_cloud(scene_, limits), {scene_.filename().string(), hash_file(scene_)}};
  if (!min_confidence_) return scene;
  try {
    CertainCloud certain = leave_out_uncertain(std::move(scene.cloud), *min_confidence_);
    scene.cloud = std::move(certain.cloud);
    scene.uncertain = certain.left_out;
  } catch (const Error& error) {
    throw Error(error.kind(), scene_.string() + ": " + error.what());
  }
  scene.input.hash =
      hash_text(scene.input.hash + " confidence " + std::to_string(*min_confidence_));
  console.say(scene_.string() + ": left out " + std::to_string(scene.uncertain) +
              " points by --min-confidence");
  return scene;
}

std::vector<std::filesystem::path> SceneArguments::files() const {
  std::vector<std::filesystem::path> all;
  for (const std::filesystem::path& file : {scene_, depth_, color_}) {
    if (!file.empty()) all.push_back(file);
  }
  return all;
}

Scene SceneArguments::load_sequence(const Console& console) const {
  const Sequence sequence = camera_.open(scene_, console);
  const TsdfVolume volume = fuse(sequence, camera_.fusion, console);
  const std::filesystem::path folder =
      scene_.filename().empty() ? scene_.parent_path().filename() : scene_.filename();
  const FusionOptions& fusion = volume.options();
  const std::string identity = sequence.hash() + " " + std::to_string(fusion.voxel_size) + " " +
                               std::to_string(fusion.truncation) + " " +
                               std::to_string(fusion.min_observations);
  Scene scene{volume.points(), {folder.string(), hash_text(identity)}};
  scene.cloud.up = sequence.up();
  scene.odometry = sequence.poses_are_estimated();
  return scene;
}

TsdfVolume fuse(const Sequence& sequence, const FusionOptions& options, const Console& console) {
  Stopwatch watch;
  TsdfVolume volume = planescope::fuse(sequence, options, console.progress());
  const double time = watch.lap();
  console.say(std::to_string(volume.frames()) + " frames fused in " + duration(time) + ", " +
              duration(time / volume.frames()) + " a frame; " +
              std::to_string(volume.block_count()) + " blocks of voxels");
  return volume;
}

Scene SceneArguments::load_view(const Console& console) const {
  const SequenceOptions options = camera_.options();
  const DepthImage depth = read_depth_image(depth_);
  const DepthCamera camera = camera_of(options, depth, depth_);
  const PinholeCamera& lens = camera.lens;
  if (!options.lens) {
    console.say("no --intrinsics: taken to be primesense, 525,525,319.5,239.5 pixels");
  }
  ColorImage color;
  std::string identity = hash_file(depth_);
  if (!color_.empty() && options.color) {
    color = read_color_image(color_);
    if (color.width != depth.width || color.height != depth.height) {
      throw Error(Error::Kind::Input,
                  color_.string() + ": is " + size_text(color.width, color.height) +
                      " pixels, its depth " + size_text(depth.width, depth.height) +
                      "; expected colour registered to depth, or --no-color");
    }
    identity += " " + hash_file(color_);
  }
  for (const double number : {lens.fx, lens.fy, lens.cx, lens.cy, camera.depth_scale,
                              camera.min_depth, camera.max_depth}) {
    identity += " " + std::to_string(number);
  }
  Scene scene{unproject(depth, color, camera), {depth_.filename().string(), hash_text(identity)}};
  for (const Eigen::Vector3f& p : scene.cloud.positions) {
    if (is_finite(p)) return scene;
  }
  throw Error(Error::Kind::Input, depth_.string() +
                                      ": no pixel has a depth in range; expected returns between "
                                      "--min-depth and --max-depth at --depth-scale");
}

}  // namespace planescope::cli
