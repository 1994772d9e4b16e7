// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "io/input_file.hpp"
#include "io/point_fields.hpp"

/// \file The header of PCD files, versions 0.5 to 0.7
/// (https://pointclouds.org/documentation/tutorials/pcd_file_format.html).
namespace planescope::io {

enum class PcdData : std::uint8_t { Ascii, Binary, Compressed };

/// A header whose counts agree with each other; whether the data are there is not looked at yet.
struct PcdHeader {
  std::vector<Field> fields;  ///< offsets are those in a binary record
  std::uint64_t stride = 0;   ///< [byte] of a binary record
  std::uint64_t width = 0, height = 1;
  std::uint64_t points = 0;                             ///< width * height, at least 1
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< [m] translation of VIEWPOINT
  PcdData data = PcdData::Ascii;
  std::uint64_t data_offset = 0;  ///< [byte] of the first byte after the header
  std::uint64_t data_line = 0;    ///< its line, from 1
};

/// True where the first word of a file can begin a PCD header.
bool is_pcd_start(std::string_view word);

/// Reads the header. WIDTH and HEIGHT may be missing (then one row of POINTS), or POINTS (then
/// WIDTH * HEIGHT); COUNT (then 1 each), VERSION and VIEWPOINT too. The rotation of VIEWPOINT is
/// read but not used: real files hold non-unit quaternions there.
/// \throws Error{Kind::Input} with the line: whatever does not follow the format.
PcdHeader read_pcd_header(const InputFile& file);

}  // namespace planescope::io
