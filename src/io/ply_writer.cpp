// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_writer.hpp"

#include <string>
#include <utility>
#include <vector>

#include "io/record_writer.hpp"

namespace planescope::io {
namespace {

OutField channel(const char* name, const PointCloud& cloud, std::uint8_t Rgb::*part) {
  return make_field<std::uint8_t>(name, Scalar::U8,
                                  [&cloud, part](std::size_t i) { return cloud.colors[i].*part; });
}

std::vector<OutField> fields_of(const PointCloud& cloud) {
  std::vector<OutField> fields = position_fields(cloud);
  if (cloud.has_colors()) {
    fields.push_back(channel("red", cloud, &Rgb::r));
    fields.push_back(channel("green", cloud, &Rgb::g));
    fields.push_back(channel("blue", cloud, &Rgb::b));
  }
  for (OutField& field : normal_fields(cloud, "nx", "ny", "nz")) fields.push_back(std::move(field));
  for (OutField& field : label_fields(cloud)) fields.push_back(std::move(field));
  for (OutField& field : surfel_fields(cloud)) fields.push_back(std::move(field));
  return fields;
}

const char* type_name(Scalar type) {
  if (type == Scalar::F64) return "double";
  if (type == Scalar::F32) return "float";
  return type == Scalar::U8 ? "uchar" : "uint";
}

std::string make_header(const PointCloud& cloud, const std::vector<OutField>& fields, bool ascii) {
  std::string header = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                       " 1.0\nelement vertex " + std::to_string(cloud.size()) + '\n';
  for (const OutField& field : fields) {
    header += std::string("property ") + type_name(field.type) + ' ' + field.name + '\n';
  }
  return header;
}

}  // namespace

void write_ply(const std::filesystem::path& file, const PointCloud& cloud, CloudEncoding encoding) {
  check_writable(cloud);
  const std::vector<OutField> fields = fields_of(cloud);
  const bool ascii = encoding == CloudEncoding::Ascii;
  write_records(file, make_header(cloud, fields, ascii) + "end_header\n", fields, cloud.size(),
                encoding);
}

void write_ply(const std::filesystem::path& file, const PointCloud& vertices,
               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  check_writable(vertices);
  const std::vector<OutField> fields = fields_of(vertices);
  const std::string header = make_header(vertices, fields, false) + "element face " +
                             std::to_string(triangles.size()) +
                             "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string faces;
  faces.reserve(triangles.size() * 13);
  for (const auto& triangle : triangles) {
    faces += '\3';
    for (const std::uint32_t v : triangle) {
      for (int shift = 0; shift < 32; shift += 8) faces += static_cast<char>(v >> shift & 0xFF);
    }
  }
  write_records(file, header, fields, vertices.size(), CloudEncoding::Binary, faces);
}

}  // namespace planescope::io
