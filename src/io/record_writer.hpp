// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/scalar.hpp"
#include "planescope/cloud.hpp"
#include "planescope/io.hpp"

/// \file Writing point records, for PCD and PLY alike.
namespace planescope::io {

/// One number of a record: its name, its type, and how to store those of points
/// [first, first + count) at `to`, `to + stride`, ...
struct OutField {
  std::string name;
  Scalar type = Scalar::F32;
  std::function<void(std::size_t first, std::size_t count, std::byte* to, std::size_t stride)> fill;
};

/// x y z: float, or double where the cloud is shifted (then origin + position). The fields refer to
/// the cloud, which must outlive them; so do those below.
std::vector<OutField> position_fields(const PointCloud& cloud);
/// Three normals of the given names, or nothing where the cloud has none.
std::vector<OutField> normal_fields(const PointCloud& cloud, const char* x, const char* y,
                                    const char* z);
/// label, or nothing where the cloud has none.
std::vector<OutField> label_fields(const PointCloud& cloud);
/// radius and confidence, where the cloud has them.
std::vector<OutField> surfel_fields(const PointCloud& cloud);

/// A field whose number of point i is value(i).
template <class T, class F>
OutField make_field(std::string name, Scalar type, F value) {
  return {std::move(name), type,
          [value](std::size_t first, std::size_t count, std::byte* to, std::size_t stride) {
            for (std::size_t i = first; i < first + count; ++i, to += stride) {
              const T number = value(i);
              std::memcpy(to, &number, sizeof(T));
            }
          }};
}

/// Appends the shortest text that reads back as the same number.
void append_number(std::string& text, double value);

/// \throws Error{Kind::Usage} the cloud has no points, or its parts differ in length.
void check_writable(const PointCloud& cloud);

/// Writes the header, then the records: little-endian and packed, or one line each. Blocks are
/// made in parallel and written in order, so that memory stays at a few blocks; the file appears
/// whole or not at all. \param tail bytes after the records, such as a mesh's faces.
/// \throws Error{Kind::Input} the folder is missing or read-only, the disk is full.
void write_records(const std::filesystem::path& file, const std::string& header,
                   const std::vector<OutField>& fields, std::size_t points, CloudEncoding encoding,
                   std::string_view tail = {});

}  // namespace planescope::io
