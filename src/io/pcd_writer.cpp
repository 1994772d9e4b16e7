// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_writer.hpp"

#include <iterator>
#include <utility>

#include "io/record_writer.hpp"
#include "planescope/error.hpp"

namespace planescope::io {
namespace {

OutField packed_rgb(const PointCloud& cloud, CloudEncoding encoding) {
  const Scalar type = encoding == CloudEncoding::Binary ? Scalar::F32 : Scalar::U32;
  return make_field<std::uint32_t>("rgb", type, [&cloud](std::size_t i) {
    const Rgb c = cloud.colors[i];
    return std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
  });
}

OutField extra_field(const PcdColumn& column, std::size_t points) {
  return std::visit(
      [&]<class T>(std::span<const T> values) {
        if (values.size() != points) {
          throw Error(Error::Kind::Usage, "the column " + column.name + " has " +
                                              std::to_string(values.size()) + " numbers for " +
                                              std::to_string(points) + " points; expected as many");
        }
        const Scalar type = std::is_signed_v<T> ? Scalar::I32 : Scalar::U32;
        return make_field<T>(column.name, type, [values](std::size_t i) { return values[i]; });
      },
      column.values);
}

std::vector<OutField> fields_of(const PointCloud& cloud, CloudEncoding encoding,
                                const std::vector<PcdColumn>& extra) {
  std::vector<OutField> fields = position_fields(cloud);
  if (cloud.has_colors()) fields.push_back(packed_rgb(cloud, encoding));
  for (OutField& field : normal_fields(cloud, "normal_x", "normal_y", "normal_z")) {
    fields.push_back(std::move(field));
  }
  for (OutField& field : label_fields(cloud)) fields.push_back(std::move(field));
  for (OutField& field : surfel_fields(cloud)) fields.push_back(std::move(field));
  for (const PcdColumn& column : extra) fields.push_back(extra_field(column, cloud.size()));
  return fields;
}

char type_letter(Scalar type) {
  if (is_real(type)) return 'F';
  return type == Scalar::U32 ? 'U' : 'I';
}

std::string viewpoint_line(const PointCloud& cloud) {
  Eigen::Vector3d sensor = Eigen::Vector3d::Zero();
  if (cloud.sensor) sensor = cloud.origin + cloud.sensor->cast<double>();
  std::string text = "VIEWPOINT ";
  for (const double c : sensor) {
    append_number(text, c);
    text += ' ';
  }
  return text + "1 0 0 0\n";  // no rotation: positions are in world axes
}

std::string header_of(const PointCloud& cloud, CloudEncoding encoding,
                      const std::vector<OutField>& fields) {
  std::string names = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const OutField& field : fields) {
    names += ' ' + field.name;
    sizes += ' ' + std::to_string(size_of(field.type));
    types += std::string{' ', type_letter(field.type)};
    counts += " 1";
  }
  const std::size_t width = cloud.organised() ? cloud.width : cloud.size();
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + names + '\n' + sizes + '\n' +
         types + '\n' + counts + "\nWIDTH " + std::to_string(width) + "\nHEIGHT " +
         std::to_string(cloud.organised() ? cloud.height : 1) + '\n' + viewpoint_line(cloud) +
         "POINTS " + std::to_string(cloud.size()) + "\nDATA " +
         (encoding == CloudEncoding::Ascii ? "ascii\n" : "binary\n");
}

}  // namespace

void write_pcd(const std::filesystem::path& file, const PointCloud& cloud, CloudEncoding encoding,
               const std::vector<PcdColumn>& extra) {
  check_writable(cloud);
  const std::vector<OutField> fields = fields_of(cloud, encoding, extra);
  write_records(file, header_of(cloud, encoding, fields), fields, cloud.size(), encoding);
}

}  // namespace planescope::io
