// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "planescope/camera.hpp"
#include "planescope/compare.hpp"
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
  Graph = 16,    ///< patch centroids and edges: ON thin and light, OFF thick, dashed, dark
};
constexpr Layer operator|(Layer a, Layer b) {
  return static_cast<Layer>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}
constexpr bool has(Layer set, Layer layer) {
  return (static_cast<std::uint8_t>(set) & static_cast<std::uint8_t>(layer)) != 0;
}

/// Where the camera stands. Auto: near the sensor for organised views, else Iso.
enum class View { Auto, Iso, Top, Front, Left, Sensor };

/// What the colour of a point says. Layers: what the layers of points say (segments, patches,
/// scene); any other one stands instead of it.
enum class ColorBy { Layers, Segment, Plane, Patch, Normal, Curvature, Truth, Rgb, Height };

/// Which colours segments, planes and patches are given. Standard: large planes calm, objects
/// vivid. Vivid, Pastel: all of them so. Grey: for print without colours.
enum class Palette { Standard, Vivid, Pastel, Grey };

/// How a camera differs from the one that the view gives.
struct CameraOptions {
  std::optional<Camera> fixed;           ///< in world coordinates, instead of the view and its fit
  std::optional<double> azimuth;         ///< [deg] where the camera stands, from the scene's front,
                                         ///< counter-clockwise seen from above
  std::optional<double> elevation;       ///< [deg] above the horizon, -90 to 90
  double roll = 0;                       ///< [deg] the camera is turned clockwise about its view
  double zoom = 1;                       ///< how many times as large, 0.01 to 100
  bool parallel = false;                 ///< parallel projection instead of perspective
  std::optional<Eigen::Vector3d> focal;  ///< [m] world: what stands in the picture's middle
  std::uint32_t fit_segment = kNoSegment;    ///< fitted to this segment instead of the scene
  std::optional<std::filesystem::path> fit;  ///< result folder: the camera that its picture has
};

/// What stands in a picture beside the scene. Letters scale with the picture.
struct AnnotationOptions {
  std::string title;       ///< at the top left; empty: none
  bool legend = false;     ///< what the colours say; that of the graph is always there
  bool labels = false;     ///< numbers of segments at their centroids, or beside what hides these
  bool scale_bar = false;  ///< a length in metres, at the bottom right
  bool axes = false;       ///< directions of x, y and z, at the bottom left
};

/// How to draw. All of it is deterministic.
struct RenderOptions {
  Layer layers = Layer::Segments;
  ColorBy color_by = ColorBy::Layers;
  Palette palette = Palette::Standard;
  /// Result folder of the same cloud: segments that are the same thing have its colours.
  std::optional<std::filesystem::path> colors_of;
  std::vector<std::uint32_t> truth;  ///< true label of each point, for ColorBy::Truth; 0: none
  View view = View::Auto;
  CameraOptions camera;
  AnnotationOptions annotation;
  std::array<int, 2> size = {1920, 1080};        ///< [pixel] width, height; 16 to 16384
  double dpi = 0;                                ///< in the PNG, 1 to 10000; 0: not said
  std::optional<Eigen::Vector3f> up;             ///< instead of the scene's own
  std::array<double, 3> background = {1, 1, 1};  ///< RGB, 0 to 1
  bool transparent = false;                      ///< no background: the PNG has an alpha channel
  int supersample = 2;            ///< antialiasing: drawn this many times larger, 1 to 4
  bool eye_dome_lighting = true;  ///< shade points by depth
  bool cull_front =
      true;  ///< leave out planes (and their points) that stand between the camera and the room
  std::vector<std::int32_t> cutaway;  ///< leave out these planes instead; empty: see cull_front
  std::size_t thin_from = 3'000'000;  ///< scenes of as many points are thinned to the nearest
                                      ///< one in each pixel that is drawn; it saves memory
  double point_size =
      0;  ///< [pixel of the final picture] 0: from the points' spacing, so that surfaces close
};

/// Draws a scene that is still in memory.
/// \throws Error{Kind::Rendering} no OpenGL context, or the picture would be uniform; \throws
/// Error{Kind::Usage} bad options; \throws Error{Kind::Input} the file cannot be written.
/// \returns the camera, in world coordinates: CameraOptions::fixed makes the same picture.
/// The PNG says in text chunks which version, input and camera made it (README, "Pictures").
Camera render(const Segmentation& scene, const PointCloud& cloud, const RenderOptions& options,
              const std::filesystem::path& png);

/// Draws a stored result folder, nothing recomputed.
Camera render(const std::filesystem::path& folder, const RenderOptions& options,
              const std::filesystem::path& png);

/// How different the colours of touching segments look to readers: the least Oklab distance
/// (Ottosson 2020) of all pairs that touch, 0 to 1; 1 where none do. 0.02 is about what is just
/// seen. Colour-blind readers are simulated by Machado, Oliveira and Fernandes (IEEE TVCG 15(6),
/// 2009) at full severity; grey is what is left in print without colours.
struct ColorDifferences {
  double normal = 1, protanopia = 1, deuteranopia = 1, tritanopia = 1, grey = 1;
  std::size_t pairs = 0;  ///< of segments that touch
};

/// Of the colours that a picture of this folder with these options has. \throws Error as render().
ColorDifferences color_differences(const std::filesystem::path& folder,
                                   const RenderOptions& options = {});

/// Once around the scene in `frames` pictures, 2 to 360, as an animated PNG that plays for ten
/// seconds and starts again; programs that know no animation show the first picture.
/// \throws Error as render().
void render_orbit(const std::filesystem::path& folder, const RenderOptions& options, int frames,
                  const std::filesystem::path& png);

/// The main job's pictures into `folder`: segments.png, planes.png, graph.png, and overview.png
/// with four panels (scene, segments, planes, graph), one camera, a title and counts in each.
/// `options.layers`, `.color_by` and the title are ignored.
void render_pictures(const Segmentation& scene, const PointCloud& cloud,
                     const RenderOptions& options, const std::filesystem::path& folder,
                     const InputInfo& input = {});

/// Writes patches.vtp, graph.vtp (edges with state, rule and values) and planes.vtp (hulls) into
/// `folder`, each whole or not at all. \throws Error{Kind::Input} cannot be written.
void save_geometry(const Segmentation& scene, const PointCloud& cloud,
                   const std::filesystem::path& folder);

/// The edges of graph.vtp in a result folder, for compare_results().
/// \param result what load_result() read from there.
/// \throws Error{Kind::Input} a file is missing or malformed, or not of that result.
std::vector<EdgeState> stored_edges(const Result& result, const std::filesystem::path& folder);

/// The OpenGL renderer's name, such as `llvmpipe (LLVM 15.0.6, 256 bits)`, and the versions of VTK,
/// for --version. \throws Error{Kind::Rendering} no context.
std::string gl_renderer();
std::string vtk_version();

}  // namespace planescope
