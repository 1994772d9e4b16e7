// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "io/read_cloud.hpp"
#include "planescope/error.hpp"

/// \file Files written byte by byte, for the tests of the readers.
namespace planescope::testing {

/// The bytes of numbers, one after the other, lowest byte first.
template <class... T>
std::string little(T... values) {
  std::string bytes;
  const auto add = [&](auto value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  (add(values), ...);
  return bytes;
}

/// The same, highest byte first.
template <class... T>
std::string big(T... values) {
  std::string bytes;
  const auto add = [&](std::string number) {
    std::reverse(number.begin(), number.end());
    bytes += number;
  };
  (add(little(values)), ...);
  return bytes;
}

/// A PCD header for a list of `points` points; `data` is "ascii", "binary", ...
inline std::string pcd_header(const std::string& fields, const std::string& sizes,
                              const std::string& types, std::size_t points,
                              const std::string& data) {
  const std::string n = std::to_string(points);
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
         "\nWIDTH " + n + "\nHEIGHT 1\nPOINTS " + n + "\nDATA " + data + "\n";
}

/// A PLY header; `rest` are the lines between format and end_header.
inline std::string ply_header(const std::string& format, const std::string& rest) {
  return "ply\nformat " + format + " 1.0\n" + rest + "end_header\n";
}

/// read_cloud() of bytes in memory.
inline PointCloud read(const std::string& bytes, const ReadLimits& limits = {}) {
  return io::read_cloud(io::InputFile("test", std::as_bytes(std::span(bytes))), limits);
}

/// What read_cloud() says of bytes that it must refuse as input; empty where it takes them.
inline std::string refusal(const std::string& bytes, const ReadLimits& limits = {}) {
  try {
    read(bytes, limits);
  } catch (const Error& error) {
    return error.kind() == Error::Kind::Input ? error.what() : "not Kind::Input";
  }
  return {};
}

}  // namespace planescope::testing
