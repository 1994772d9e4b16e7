// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"
#include "planescope/planes.hpp"

/// \file Seeded indoor scenes with ground truth: what tests, benchmarks and the quick start run on.
namespace planescope {

/// What to synthesize.
struct SynthesisOptions {
  std::uint64_t random_seed = 1;  ///< the room, its furniture, the sampling and the noise
  std::uint64_t points =
      200'000;              ///< evenly sampled: number of points, exactly; ignored with views
  std::uint32_t views = 0;  ///< > 0: seen by this many depth cameras (640x480) inside the room
  double noise = 0.002;     ///< [m] standard deviation along the normal; with views: at 1 m depth,
                            ///< growing with z^2
  bool ceiling = false;     ///< close the room
  bool normals = false;     ///< store normals, oriented to the sensor or to the room's inside
  Eigen::Vector3d offset =
      Eigen::Vector3d::Zero();  ///< [m] added to every position (map coordinates)
};

/// A planar face of the scene that is known exactly.
struct TruePlane {
  Plane plane;              ///< relative to the cloud's origin; normal towards the free side
  std::uint32_t label = 0;  ///< the object (value of PointCloud::labels) that it belongs to
  double area = 0;          ///< [m^2] of the face
  std::string name;         ///< `floor`, `wall 2`, `table 1 top`, ...
  bool structural = false;  ///< floor, wall, ceiling: must be found
};

/// A scene and what is true of it.
struct SynthesizedScene {
  PointCloud cloud;  ///< with colours and with labels, one an object, from 1
  std::vector<TruePlane> planes;
  std::vector<std::string> objects;  ///< index = label - 1: `floor`, `table 1`, `chair 3`, ...
};

/// A furnished room (walls, floor, tables, chairs, boxes, shelves, a bed, spheres, cylinders), z
/// up, floor at z = 0. Same options, same bytes. \throws Error{Kind::Usage} a value is out of
/// range.
SynthesizedScene synthesize(const SynthesisOptions& options);

/// Writes what synthesize() knows beside the cloud: objects and planes as JSON.
void write_truth(const SynthesizedScene& scene, const std::filesystem::path& json_file);

/// Reads that JSON's planes back. \throws Error{Kind::Input} missing or malformed.
std::vector<TruePlane> read_true_planes(const std::filesystem::path& json_file);

}  // namespace planescope
