// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "planescope/pipeline.hpp"
#include "planescope/result.hpp"

/// \file Drawing without a display (target planescope::render; programs link planescope::offscreen
/// too). No VTK type crosses this header.
namespace planescope {

/// What to draw; combine with |.
enum class Layer : std::uint8_t {
  Scene = 1,     ///< points in their own colours (by height where the cloud has none)
  Patches = 2,   ///< points coloured by patch
  Segments = 4,  ///< points coloured by segment
  Planes = 8,    ///< translucent outlined hull of each supporting plane's segments
  Graph = 16,    ///< patch centroids and edges: ON thin and blue, OFF thick, dashed and red
};
constexpr Layer operator|(Layer a, Layer b) {
  return static_cast<Layer>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}
constexpr bool has(Layer set, Layer layer) {
  return (static_cast<std::uint8_t>(set) & static_cast<std::uint8_t>(layer)) != 0;
}

/// Where the camera stands. Auto: near the sensor for organised views, else Iso.
enum class View { Auto, Iso, Top, Front, Left, Sensor };

/// How to draw. All of it is deterministic.
struct RenderOptions {
  Layer layers = Layer::Segments;
  View view = View::Auto;
  std::array<int, 2> size = {1920, 1080};        ///< [pixel] width, height; 16 to 16384
  std::optional<Eigen::Vector3f> up;             ///< instead of the scene's own
  std::array<double, 3> background = {1, 1, 1};  ///< RGB, 0 to 1
  int supersample = 2;            ///< antialiasing: drawn this many times larger, 1 to 4
  bool eye_dome_lighting = true;  ///< shade points by depth
  bool cull_front =
      true;  ///< leave out planes (and their points) that stand between the camera and the room
  double point_size =
      0;  ///< [pixel of the final picture] 0: from the points' spacing, so that surfaces close
  std::string title;  ///< drawn at the top left; empty: none
};

/// Draws a scene that is still in memory.
/// \throws Error{Kind::Rendering} no OpenGL context, or the picture would be uniform; \throws
/// Error{Kind::Usage} bad size; \throws Error{Kind::Input} the file cannot be written.
void render(const Segmentation& scene, const PointCloud& cloud, const RenderOptions& options,
            const std::filesystem::path& png);

/// Draws a stored result folder, nothing recomputed.
void render(const std::filesystem::path& folder, const RenderOptions& options,
            const std::filesystem::path& png);

/// The main job's pictures into `folder`: segments.png, planes.png, graph.png, and overview.png
/// with four panels (scene, segments, planes, graph), one camera, a title and counts in each.
/// `options.layers` and `.title` are ignored.
void render_pictures(const Segmentation& scene, const PointCloud& cloud,
                     const RenderOptions& options, const std::filesystem::path& folder,
                     const InputInfo& input = {});

/// Writes patches.vtp, graph.vtp (edges with state, rule and values) and planes.vtp (hulls) into
/// `folder`, each whole or not at all. \throws Error{Kind::Input} cannot be written.
void save_geometry(const Segmentation& scene, const PointCloud& cloud,
                   const std::filesystem::path& folder);

/// The OpenGL renderer's name, such as `llvmpipe (LLVM 15.0.6, 256 bits)`, and the versions of VTK,
/// for --version. \throws Error{Kind::Rendering} no context.
std::string gl_renderer();
std::string vtk_version();

}  // namespace planescope
