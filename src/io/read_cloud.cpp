// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/read_cloud.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "io/byte_cursor.hpp"
#include "io/numbers.hpp"
#include "io/pcd_header.hpp"
#include "io/pcd_reader.hpp"
#include "io/ply_reader.hpp"

namespace planescope {
namespace io {
namespace {

/// The first word of the file, at most 16 characters of it: the magic.
std::string first_word(const InputFile& file) {
  constexpr std::uint64_t kLongest = 16;
  std::string start(static_cast<std::size_t>(std::min(kLongest, file.size())), '\0');
  file.read_at(0, std::as_writable_bytes(std::span(start)));
  return start.substr(0, start.find_first_of(" \t\r\n"));
}

}  // namespace

PointCloud read_cloud(const InputFile& file, const ReadLimits& limits) {
  const std::string word = first_word(file);
  if (word == "ply") return read_ply(file, limits).cloud;
  if (is_pcd_start(word)) return read_pcd(file, limits).cloud;
  file.fail("begins with " + in_quotes(word) +
            ", neither PCD nor PLY; convert it to one of them first");
}

}  // namespace io

PointCloud read_cloud(const std::filesystem::path& file, const ReadLimits& limits) {
  return io::read_cloud(io::InputFile(file), limits);
}

}  // namespace planescope
