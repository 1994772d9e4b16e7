// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_points.hpp"

#include <bit>
#include <cstring>

#include "planescope/error.hpp"

namespace planescope {
namespace {

static_assert(std::endian::native == std::endian::little, "PCD's binary layout is little-endian");

bool shifted(const PointCloud& cloud) { return !cloud.origin.isZero(0); }

std::size_t point_bytes(const PointCloud& cloud) { return (shifted(cloud) ? 24u : 12u) + 16u; }

/// The header is a function of the numbers in result.json, so that a file that does not belong to
/// it is noticed by its first bytes.
std::string header(const PointCloud& cloud) {
  const std::string size = shifted(cloud) ? "8 8 8" : "4 4 4";
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
         "FIELDS x y z rgb label plane patch\nSIZE " +
         size + " 4 4 4 4\nTYPE F F F F U I I\nCOUNT 1 1 1 1 1 1 1\nWIDTH " +
         std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) +
         "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(std::uint64_t{cloud.width} * cloud.height) + "\nDATA binary\n";
}

template <class T>
void put(char*& out, const T& value) {
  std::memcpy(out, &value, sizeof value);
  out += sizeof value;
}

template <class T>
T get(const char*& in) {
  T value;
  std::memcpy(static_cast<void*>(&value), in, sizeof value);
  in += sizeof value;
  return value;
}

Rgb unpack(std::uint32_t packed) {
  return {static_cast<std::uint8_t>(packed >> 16), static_cast<std::uint8_t>(packed >> 8),
          static_cast<std::uint8_t>(packed)};
}

std::uint32_t pack(Rgb c) {
  return std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
}

}  // namespace

std::string points_pcd(const ResultPoints& points) {
  const PointCloud& cloud = points.cloud;
  std::string bytes = header(cloud);
  const std::size_t start = bytes.size();
  bytes.resize(start + cloud.size() * point_bytes(cloud));
  char* out = bytes.data() + start;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (shifted(cloud)) {
      put(out, Eigen::Vector3d(cloud.origin + cloud.positions[i].cast<double>()));
    } else {
      put(out, cloud.positions[i]);
    }
    put(out, cloud.has_colors() ? pack(cloud.colors[i]) : 0u);
    put(out, points.label[i]);
    put(out, points.plane[i]);
    put(out, points.patch[i]);
  }
  return bytes;
}

void parse_points_pcd(std::string_view bytes, const std::filesystem::path& file, Result& result) {
  PointCloud& cloud = result.cloud;
  const std::string expected = header(cloud);
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (!bytes.starts_with(expected) ||
      (bytes.size() - expected.size()) / point_bytes(cloud) != count ||
      (bytes.size() - expected.size()) % point_bytes(cloud) != 0) {
    throw Error(Error::Kind::Input, file.string() + ": not the " + std::to_string(count) +
                                        " points that result.json beside it tells of; run "
                                        "`planescope segment` again");
  }
  cloud.positions.resize(count);
  if (result.has_colors) cloud.colors.resize(count);
  result.point_label.resize(count);
  result.point_plane.resize(count);
  result.point_patch.resize(count);
  const char* in = bytes.data() + expected.size();
  for (std::size_t i = 0; i < count; ++i) {
    cloud.positions[i] = shifted(cloud) ? (get<Eigen::Vector3d>(in) - cloud.origin).cast<float>()
                                        : get<Eigen::Vector3f>(in);
    const Rgb color = unpack(get<std::uint32_t>(in));
    if (result.has_colors) cloud.colors[i] = color;
    result.point_label[i] = get<std::uint32_t>(in);
    result.point_plane[i] = get<std::int32_t>(in);
    result.point_patch[i] = get<std::int32_t>(in);
  }
}

}  // namespace planescope
