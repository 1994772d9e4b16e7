// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>

#include "planescope/cloud.hpp"

/// \file Reading and writing point clouds: our own bounded readers over one byte cursor. Every
/// count in a header is checked against the bytes that are there before anything is allocated.
namespace planescope {

/// Limits that guard against files that ask for more than the caller wants to give.
struct ReadLimits {
  std::uint64_t max_points =
      std::numeric_limits<std::uint32_t>::max() / 2;  ///< points, finite or not
};

/// Reads a PCD (ascii, binary, binary_compressed) or PLY (ascii, little or big endian) file; the
/// content's magic decides, not the name. Fields: x y z (float or double; required), rgb | rgba |
/// red green blue, normal_x normal_y normal_z | nx ny nz, label, and of surfel maps radius and
/// confidence (any number type; a radius that is not positive and finite, or a confidence that is
/// not finite, is unknown: NaN). Others, and PLY elements other than `vertex`, are skipped.
/// Organised PCD files keep width and height (a single column is a list), and their VIEWPOINT is
/// taken as the sensor's position; that of a list only where it is not (0,0,0). A cloud that lies
/// further than 1 km from the origin is shifted in double before it becomes float: `origin` then
/// holds the shift (whole metres, the median of a fixed sample), otherwise it is zero. Without NaN,
/// PCD's usual (0,0,0) is an ordinary point. \throws Error{Kind::Input} missing, malformed,
/// truncated or empty file, with line or byte offset; no finite point.
PointCloud read_cloud(const std::filesystem::path& file, const ReadLimits& limits = {});

/// How write_cloud() lays out the file.
enum class CloudEncoding { Ascii, Binary };

/// Writes PCD or PLY, by the extension (.pcd, .ply): x y z [rgb] [normals] [label] [radius]
/// [confidence], whole or not at all (temporary name, then rename). x y z are float, or double
/// where the cloud's origin is not zero. PLY has no place for width, height and sensor. \throws
/// Error{Kind::Input} the extension is neither; the folder is missing; the disk is full. \throws
/// Error{Kind::Usage} the cloud has no points, or its parts differ in length.
void write_cloud(const PointCloud& cloud, const std::filesystem::path& file,
                 CloudEncoding encoding = CloudEncoding::Binary);

/// A surfel map without the surfels that are not sure enough.
struct CertainCloud {
  PointCloud cloud;          ///< the points' number and order stay: those left out are NaN
  std::size_t left_out = 0;  ///< points that were finite and are not now
};

/// Leaves out the points whose confidence is below `min_confidence` or unknown: they become points
/// without a return, so that all that is said of points by their number stays true.
/// \throws Error{Kind::Input} the cloud has no confidences, or no point would be left.
CertainCloud leave_out_uncertain(PointCloud cloud, double min_confidence);

}  // namespace planescope
