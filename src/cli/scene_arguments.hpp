// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "planescope/cloud.hpp"
#include "planescope/fusion.hpp"
#include "planescope/io.hpp"
#include "planescope/result.hpp"
#include "planescope/sequence.hpp"

namespace CLI {
class App;
}

/// \file What a subcommand works on: a cloud, a depth image, or an RGB-D sequence.
namespace planescope::cli {

struct Console;

/// How depth images become points: the camera, and which frames of a sequence.
class DepthArguments {
 public:
  static constexpr const char* kGroup = "Depth images and sequences";

  /// Adds --intrinsics, --depth-scale, --min-depth, --max-depth, --no-color.
  void declare_camera(CLI::App& command);
  /// Adds --frames, --layout and --odometry, and what fusion takes: --fusion-voxel, --truncation,
  /// --min-observations.
  void declare_sequence(CLI::App& command);

  /// What was given. \throws Error{Kind::Usage} bad text; Error{Kind::Input} the camera's file
  /// cannot be read.
  SequenceOptions options() const;

  /// Opens a sequence, with poses by odometry where it has none; says on `console` what it found.
  /// Farther than 4 m is left out unless
  /// --max-depth was given: structured light is off by centimetres there.
  /// \throws Error as Sequence and give_poses() do.
  Sequence open(const std::filesystem::path& folder, const Console& console) const;

  FusionOptions fusion;  ///< as given

 private:
  std::string intrinsics_, frames_, layout_;
  SequenceOptions given_;
  std::optional<double> max_depth_;
  bool no_color_ = false, odometry_ = false;
};

/// The cloud to segment, and what is said of it in result.json.
struct Scene {
  PointCloud cloud;
  InputInfo input;
  std::size_t uncertain = 0;  ///< points left out by --min-confidence
  bool odometry = false;      ///< a sequence's poses were estimated
};

/// Fuses a sequence with a progress bar, and says how much came of it.
TsdfVolume fuse(const Sequence& sequence, const FusionOptions& options, const Console& console);

/// SCENE or --depth: a point cloud's file, a folder with a sequence, or a single view.
class SceneArguments {
 public:
  void declare(CLI::App& command);

  /// \throws Error{Kind::Usage} neither or both were given, or values are out of range.
  void check() const;

  /// Reads, and unprojects. Says on `console` which camera was assumed.
  /// \throws Error{Kind::Input} a file is missing or malformed.
  Scene load(const Console& console, const ReadLimits& limits) const;

  /// The files that were given.
  std::vector<std::filesystem::path> files() const;

 private:
  Scene load_cloud(const Console& console, const ReadLimits& limits) const;
  Scene load_view(const Console& console) const;
  Scene load_sequence(const Console& console) const;

  std::filesystem::path scene_, depth_, color_;
  std::optional<double> min_confidence_;
  DepthArguments camera_;
};

}  // namespace planescope::cli
