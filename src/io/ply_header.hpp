// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/input_file.hpp"
#include "io/point_fields.hpp"

/// \file The header of PLY files, version 1.0 (G. Turk, "The PLY Polygon File Format", 1994).
namespace planescope::io {

enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };

/// One `element` with its properties.
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Field> properties;  ///< offsets are those in a record without lists
  std::uint64_t stride = 0;       ///< [byte] of a record; of a list only its length is counted
  bool has_list = false;
};

/// A header that follows the format; whether the data are there is not looked at yet.
struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<PlyElement> elements;  ///< in the order of the data
  std::size_t vertex = 0;            ///< the index of the element `vertex`
  std::uint64_t data_offset = 0;     ///< [byte] of the first byte after the header
  std::uint64_t data_line = 0;       ///< its line, from 1
};

/// Reads the header. \throws Error{Kind::Input} with the line: whatever does not follow the format;
/// no element `vertex`, or two.
PlyHeader read_ply_header(const InputFile& file);

}  // namespace planescope::io
