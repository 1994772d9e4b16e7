// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "io_bytes.hpp"

/// \file The readers' contract as files that break it: each rule with bytes, and what the refusal
/// must say. The bytes lie in tests/malformed too, for other programs and as seeds of fuzzing.
namespace planescope::testing {

struct Malformed {
  std::string name, bytes;
  std::string says;  ///< a part of the message
};

inline void PrintTo(const Malformed& file, std::ostream* out) { *out << file.name; }

/// A good file of two points with one piece replaced by another.
inline std::string pcd(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z rgb label\nSIZE 4 4 4 4 4\nTYPE F F F U U\n"
      "COUNT 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n"
      "1 2 3 0 4\n5 6 7 0 8\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

inline std::string ply(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "end_header\n1 2 3 4 5 6\n7 8 9 0 1 2\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

inline std::string binary(const std::string& points, const std::string& body,
                          const std::string& data = "binary") {
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " + points + "\nHEIGHT 1\nPOINTS " + points +
         "\nDATA " + data + "\n" + body;
}

/// One point, compressed: the sizes that are claimed, and the stream.
inline std::string compressed(std::uint32_t from, std::uint32_t to, const std::string& stream,
                              const std::string& points = "1") {
  return binary(points, little(from, to) + stream, "binary_compressed");
}

inline const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string kPoint = little(1.F, 2.F, 3.F);

std::vector<Malformed> magic_rules();
std::vector<Malformed> pcd_header_rules();
std::vector<Malformed> field_rules();
std::vector<Malformed> pcd_ascii_rules();
std::vector<Malformed> pcd_binary_rules();
std::vector<Malformed> pcd_compressed_rules();
std::vector<Malformed> ply_header_rules();
std::vector<Malformed> ply_data_rules();

}  // namespace planescope::testing
