// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "io/byte_cursor.hpp"
#include "io/numbers.hpp"

namespace planescope::io {
namespace {

constexpr std::array<std::string_view, 10> kKeywords = {
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
constexpr std::uint64_t kMaxCount = std::uint64_t{1} << 16;   // numbers of one field
constexpr std::uint64_t kMaxStride = std::uint64_t{1} << 20;  // [byte] of one point
constexpr std::uint64_t kMaxSide = std::numeric_limits<std::uint32_t>::max();

/// One line of the header: what follows its keyword.
struct Entry {
  std::uint64_t line = 0;  ///< 0: the keyword is not in the header
  std::vector<std::string> values;
};

/// The header's lines by keyword, not interpreted yet.
class Entries {
 public:
  explicit Entries(const InputFile& file) : file_(file) {
    HeaderLines lines(file);
    while (!has("DATA")) {
      const std::vector<std::string_view>& words = lines.next("DATA");
      add(words, lines.line());
    }
    data_offset = lines.offset();
    data_line = lines.line() + 1;
  }

  bool has(std::string_view keyword) const { return get(keyword).line != 0; }
  const Entry& get(std::string_view keyword) const {
    return entries_[static_cast<std::size_t>(
        std::find(kKeywords.begin(), kKeywords.end(), keyword) - kKeywords.begin())];
  }
  /// The entry, which has to have `count` values.
  const Entry& get(std::string_view keyword, std::size_t count) const {
    const Entry& entry = get(keyword);
    if (entry.line == 0) file_.fail("the header has no line " + std::string(keyword));
    if (entry.values.size() != count) {
      file_.fail_line(entry.line, std::string(keyword) + " has " +
                                      std::to_string(entry.values.size()) + " values; expected " +
                                      std::to_string(count));
    }
    return entry;
  }

  /// The value as a whole number in [least, most].
  std::uint64_t whole(std::string_view keyword, std::size_t i, std::uint64_t least,
                      std::uint64_t most) const {
    const Entry& entry = get(keyword);
    const auto value = parse_word<std::uint64_t>(entry.values[i]);
    if (value && *value >= least && *value <= most) return *value;
    file_.fail_line(entry.line, std::string(keyword) + " has " + in_quotes(entry.values[i]) +
                                    "; expected a whole number from " + std::to_string(least) +
                                    " to " + std::to_string(most));
  }

  std::uint64_t data_offset = 0, data_line = 0;

 private:
  void add(const std::vector<std::string_view>& words, std::uint64_t line) {
    if (words.empty() || words[0].front() == '#') return;
    const std::string_view keyword = words[0] == "COLUMNS" ? "FIELDS" : words[0];  // before 0.5
    const auto found = std::find(kKeywords.begin(), kKeywords.end(), keyword);
    if (found == kKeywords.end()) {
      file_.fail_line(line, in_quotes(words[0]) +
                                " is no keyword of PCD; expected VERSION, FIELDS, "
                                "SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, "
                                "POINTS or DATA");
    }
    Entry& entry = entries_[static_cast<std::size_t>(found - kKeywords.begin())];
    if (entry.line != 0) {
      file_.fail_line(line, std::string(keyword) + " is there twice; the first is in line " +
                                std::to_string(entry.line));
    }
    entry.line = line;
    entry.values.assign(words.begin() + 1, words.end());
  }

  const InputFile& file_;
  std::array<Entry, kKeywords.size()> entries_;
};

void check_version(const InputFile& file, const Entries& entries) {
  if (!entries.has("VERSION")) return;
  const Entry& entry = entries.get("VERSION", 1);
  std::string_view version = entry.values[0];
  if (version.starts_with("0")) version.remove_prefix(1);
  if (version == ".7" || version == ".6" || version == ".5") return;
  file.fail_line(entry.line,
                 "VERSION is " + in_quotes(entry.values[0]) + "; expected 0.7 (or 0.6, 0.5)");
}

Scalar scalar_of(const InputFile& file, const Entries& entries, std::size_t i) {
  const std::uint64_t size = entries.whole("SIZE", i, 1, 8);
  const Entry& types = entries.get("TYPE");
  const std::string& type = types.values[i];
  using enum Scalar;
  if (size == 1 && type == "I") return I8;
  if (size == 1 && type == "U") return U8;
  if (size == 2 && type == "I") return I16;
  if (size == 2 && type == "U") return U16;
  if (size == 4 && type == "I") return I32;
  if (size == 4 && type == "U") return U32;
  if (size == 4 && type == "F") return F32;
  if (size == 8 && type == "I") return I64;
  if (size == 8 && type == "U") return U64;
  if (size == 8 && type == "F") return F64;
  file.fail_line(types.line, "TYPE " + in_quotes(type) + " with SIZE " + std::to_string(size) +
                                 "; expected I or U of 1, 2, 4 or 8 bytes, or F of 4 or 8");
}

void read_fields(const InputFile& file, const Entries& entries, PcdHeader& header) {
  if (!entries.has("FIELDS")) file.fail("the header has no line FIELDS");
  const Entry& names = entries.get("FIELDS");
  const std::size_t count = names.values.size();
  entries.get("SIZE", count);
  entries.get("TYPE", count);
  if (entries.has("COUNT")) entries.get("COUNT", count);
  for (std::size_t i = 0; i < count; ++i) {
    Field field{.name = names.values[i], .type = scalar_of(file, entries, i), .list = {}};
    if (entries.has("COUNT")) field.count = entries.whole("COUNT", i, 1, kMaxCount);
    field.offset = header.stride;
    header.stride += field.count * size_of(field.type);  // at most 2^16 * 8 more: no overflow
    if (header.stride > kMaxStride) {
      file.fail_line(names.line, "a point has more than " + std::to_string(kMaxStride) +
                                     " bytes; expected a few numbers");
    }
    header.fields.push_back(field);
  }
}

void read_counts(const InputFile& file, const Entries& entries, PcdHeader& header) {
  const bool sized = entries.has("WIDTH") || entries.has("HEIGHT");
  if (sized) {
    entries.get("WIDTH", 1);
    entries.get("HEIGHT", 1);
    header.width = entries.whole("WIDTH", 0, 0, kMaxSide);
    header.height = entries.whole("HEIGHT", 0, 0, kMaxSide);
  }
  header.points = header.width * header.height;  // of two 32-bit numbers: no overflow
  if (!sized || entries.has("POINTS")) {
    entries.get("POINTS", 1);
    header.points = entries.whole("POINTS", 0, 0, std::numeric_limits<std::uint64_t>::max());
    if (!sized) header.width = header.points;
    if (header.points != header.width * header.height) {
      file.fail_line(entries.get("POINTS").line,
                     "POINTS is " + std::to_string(header.points) + ", but WIDTH x HEIGHT is " +
                         std::to_string(header.width) + " x " + std::to_string(header.height) +
                         "; expected the same number");
    }
  }
  if (header.points == 0) file.fail("the file has no points; expected at least one");
  if (header.width > kMaxSide) {
    file.fail_line(entries.get("POINTS").line, "POINTS is more than 32 bits hold");
  }
}

void read_viewpoint(const InputFile& file, const Entries& entries, PcdHeader& header) {
  if (!entries.has("VIEWPOINT")) return;
  const Entry& entry = entries.get("VIEWPOINT", 7);
  for (std::size_t i = 0; i < 7; ++i) {
    const auto value = parse_word<double>(entry.values[i]);
    if (!value || !std::isfinite(*value)) {
      file.fail_line(entry.line,
                     "VIEWPOINT has " + in_quotes(entry.values[i]) + "; expected a finite number");
    }
    if (i < 3) header.viewpoint[static_cast<Eigen::Index>(i)] = *value;
  }
}

PcdData read_data(const InputFile& file, const Entries& entries) {
  const Entry& entry = entries.get("DATA", 1);
  if (entry.values[0] == "ascii") return PcdData::Ascii;
  if (entry.values[0] == "binary") return PcdData::Binary;
  if (entry.values[0] == "binary_compressed") return PcdData::Compressed;
  file.fail_line(entry.line, "DATA is " + in_quotes(entry.values[0]) +
                                 "; expected ascii, binary or binary_compressed");
}

}  // namespace

bool is_pcd_start(std::string_view word) {
  return word.starts_with('#') || word == "COLUMNS" ||
         std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

PcdHeader read_pcd_header(const InputFile& file) {
  const Entries entries(file);
  PcdHeader header;
  check_version(file, entries);
  read_fields(file, entries, header);
  read_counts(file, entries, header);
  read_viewpoint(file, entries, header);
  header.data = read_data(file, entries);
  header.data_offset = entries.data_offset;
  header.data_line = entries.data_line;
  return header;
}

}  // namespace planescope::io
