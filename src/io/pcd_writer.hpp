// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/io.hpp"

/// \file Writing PCD files, with columns beyond those of a cloud.
namespace planescope::io {

/// A named column with one number a point: TYPE U or I, SIZE 4. Refers to its numbers.
struct PcdColumn {
  std::string name;
  std::variant<std::span<const std::uint32_t>, std::span<const std::int32_t>> values;
};

/// Writes x y z [rgb] [normal_x normal_y normal_z] [label], then the extra columns. Organised
/// clouds keep WIDTH and HEIGHT; VIEWPOINT is the sensor's world position, or zero where it is not
/// known. `rgb` is the packed colour as float in binary files (what PCL expects there), as unsigned
/// integer in ascii ones (as PCL writes them).
/// \code
/// // the result folder's x y z rgb label plane patch:
/// PointCloud points = ...;  // positions, colors; labels = the segments
/// io::write_pcd(folder / "points.pcd", points, CloudEncoding::Binary,
///               {{"plane", std::span<const std::int32_t>(planes)},
///                {"patch", std::span<const std::int32_t>(patches)}});
/// \endcode
/// \throws Error{Kind::Usage} no points, or parts or columns that differ in length.
/// \throws Error{Kind::Input} the folder is missing or read-only; the disk is full.
void write_pcd(const std::filesystem::path& file, const PointCloud& cloud, CloudEncoding encoding,
               const std::vector<PcdColumn>& extra = {});

}  // namespace planescope::io
