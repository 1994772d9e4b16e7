// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"
#include "planescope/options.hpp"
#include "planescope/planes.hpp"

/// \file Seeded indoor scenes with ground truth: what tests, benchmarks and the quick start run on.
namespace planescope {

/// What to synthesize. Ranges are checked by synthesize().
struct SynthesisOptions {
  std::uint64_t random_seed = 1;   ///< the room, its furniture, the sampling and the noise
  std::uint64_t points = 200'000;  ///< evenly sampled: number of points, exactly, 1 .. 16,000,000;
                                   ///< ignored with views
  std::uint32_t views = 0;  ///< > 0: seen by this many depth cameras (640x480) inside the room, up
                            ///< to 1000 (about 9 MB a view)
  double noise = 0.002;     ///< [m] standard deviation along the normal; with views: at 1 m depth,
                            ///< growing with z^2, along the ray; 0 .. 0.2
  bool ceiling = false;     ///< close the room
  bool normals = false;     ///< store normals, oriented to the sensor or to the room's inside
  Eigen::Vector3d offset =
      Eigen::Vector3d::Zero();  ///< [m] added to every position (map coordinates): its whole metres
                                ///< become the cloud's origin; at most 1e9 each way
};

/// A planar face of the scene that is known exactly, and of which the cloud shows a part.
struct TruePlane {
  Plane plane;              ///< relative to the cloud's origin; normal towards the free side
  std::uint32_t label = 0;  ///< the object (value of PointCloud::labels) that it belongs to
  double area = 0;  ///< [m^2] of the face that the cloud shows: its free part or, with views, what
                    ///< the cameras saw of it (in cells of 5 cm)
  Eigen::Vector3f centroid =
      Eigen::Vector3f::Zero();  ///< [m] of that part, relative to the cloud's origin
  std::string name;             ///< `floor`, `wall 2`, `table 1 top`, ...
  bool structural = false;      ///< floor, wall, ceiling: must be found
};

/// A scene and what is true of it.
struct SynthesizedScene {
  PointCloud cloud;  ///< with colours and with labels, one an object, from 1
  std::vector<TruePlane> planes;
  std::vector<std::string> objects;  ///< index = label - 1: `floor`, `table 1`, `chair 3`, ...
};

/// A furnished room (walls, floor, tables, chairs, boxes, shelves, a bed, a cupboard, spheres,
/// cylinders), z up, floor at z = 0, turned about z by a seeded angle so that no axis is special.
/// Faces that nobody can see (the underside of a box on the floor, the floor below it, the wall a
/// hand's breadth behind a shelf) carry no points.
///
/// Without views: exactly `points` points, spread evenly over the visible surfaces. One view: an
/// organised 640x480 cloud in the camera's frame (x right, y down, z forward; f = 525, c = (319.5,
/// 239.5)), NaN where there is no return, the sensor at `offset`. More views: all their returns in
/// the room's frame, unorganised. Returns are lost at grazing angles (from 75 degrees), at depth
/// edges, and nearer than 0.5 m or farther than 6 m.
///
/// Same options, same bytes, at any number of threads.
/// \throws Error{Kind::Usage} a value is out of range.
SynthesizedScene synthesize(const SynthesisOptions& options);

inline constexpr std::uint32_t kMostFrames = 10'000;  ///< of write_sequence()

/// What a depth camera sees that is carried through the room of synthesize(): `frames` depth images
/// (PNG, millimetres) and colour images with exact poses, as an RGB-D sequence in the layout of
/// Redwood: depth/, image/, camera.txt, trajectory.log, in `folder`, which is made where it is
/// missing. Noise and lost returns are those of views. Same options, same bytes.
/// \returns the room itself, sampled evenly and without noise (options.points), for comparison with
/// what is fused from the frames; and its planes, with the area that the frames saw.
/// \throws Error{Kind::Usage} a value is out of range; Error{Kind::Input} it cannot be written.
SynthesizedScene write_sequence(const SynthesisOptions& options, std::uint32_t frames,
                                const std::filesystem::path& folder, const Progress& progress = {});

/// Writes what synthesize() knows beside the cloud: objects and planes as JSON, whole or not at
/// all. \throws Error{Kind::Input} the folder is missing or cannot be written.
void write_truth(const SynthesizedScene& scene, const std::filesystem::path& json_file);

/// Reads that JSON's planes back, untrusted.
/// \param origin the origin of the cloud that the planes are for: a reader of the cloud may have
/// chosen another one than synthesize() did, so the planes are moved to it.
/// \throws Error{Kind::Input} missing or malformed, with the byte or the plane.
std::vector<TruePlane> read_true_planes(const std::filesystem::path& json_file,
                                        const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

}  // namespace planescope
