// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_header.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "io/byte_cursor.hpp"
#include "io/numbers.hpp"

namespace planescope::io {
namespace {

using Words = std::vector<std::string_view>;

std::optional<Scalar> scalar_of(std::string_view name) {
  using enum Scalar;
  constexpr std::array<std::pair<std::string_view, Scalar>, 16> types = {{
      {"char", I8},
      {"uchar", U8},
      {"short", I16},
      {"ushort", U16},
      {"int", I32},
      {"uint", U32},
      {"float", F32},
      {"double", F64},
      {"int8", I8},
      {"uint8", U8},
      {"int16", I16},
      {"uint16", U16},
      {"int32", I32},
      {"uint32", U32},
      {"float32", F32},
      {"float64", F64},
  }};
  for (const auto& [known, type] : types) {
    if (known == name) return type;
  }
  return std::nullopt;
}

/// Builds the header line by line.
class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(const InputFile& file) : file_(file), lines_(file) {}

  PlyHeader read() {
    const Words& magic = lines_.next("end_header");
    if (magic.size() != 1 || magic[0] != "ply") fail("the first line is not \"ply\"");
    while (true) {
      const Words& words = lines_.next("end_header");
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header" && words.size() == 1) break;
      add(words);
    }
    finish();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { file_.fail_line(lines_.line(), what); }

  void add(const Words& words) {
    if (words[0] == "format") return add_format(words);
    if (words[0] == "element") return add_element(words);
    if (words[0] == "property") return add_property(words);
    fail(in_quotes(words[0]) +
         " is no keyword of PLY; expected format, comment, obj_info, element, "
         "property or end_header");
  }

  void add_format(const Words& words) {
    if (has_format_) fail("the format is there twice");
    if (words.size() != 3 || words[2] != "1.0") {
      fail("the format is not understood; expected its name and version 1.0");
    }
    if (words[1] == "ascii") {
      header_.format = PlyFormat::Ascii;
    } else if (words[1] == "binary_little_endian") {
      header_.format = PlyFormat::LittleEndian;
    } else if (words[1] == "binary_big_endian") {
      header_.format = PlyFormat::BigEndian;
    } else {
      fail("the format is " + in_quotes(words[1]) +
           "; expected ascii, binary_little_endian or binary_big_endian");
    }
    has_format_ = true;
  }

  void add_element(const Words& words) {
    if (words.size() != 3) fail("an element needs a name and a count");
    const auto count = parse_word<std::uint64_t>(words[2]);
    if (!count) {
      fail("the element " + in_quotes(words[1]) + " has the count " + in_quotes(words[2]) +
           "; expected a whole number");
    }
    header_.elements.push_back({.name = std::string(words[1]), .count = *count, .properties = {}});
  }

  Scalar type_of(std::string_view name) const {
    const std::optional<Scalar> type = scalar_of(name);
    if (type) return *type;
    fail(in_quotes(name) +
         " is no type of PLY; expected char, uchar, short, ushort, int, uint, "
         "float, double, or int8 to float64");
  }

  void add_property(const Words& words) {
    if (header_.elements.empty()) fail("a property comes before the first element");
    PlyElement& element = header_.elements.back();
    Field field;
    field.offset = element.stride;
    if (words.size() == 5 && words[1] == "list") {
      field.list = type_of(words[2]);
      if (is_real(*field.list)) fail("the length of a list is a real; expected an integer type");
      field.type = type_of(words[3]);
      element.has_list = true;
    } else if (words.size() == 3) {
      field.type = type_of(words[1]);
    } else {
      fail(
          "the property is not understood; expected \"property <type> <name>\" or \"property list "
          "<type> <type> <name>\"");
    }
    field.name = std::string(words.back());
    element.stride += size_of(field.list.value_or(field.type));
    element.properties.push_back(field);
  }

  void finish() {
    if (!has_format_) fail("the header ends without a format");
    std::size_t found = 0;
    for (std::size_t i = 0; i < header_.elements.size(); ++i) {
      if (header_.elements[i].name != "vertex") continue;
      header_.vertex = i;
      ++found;
    }
    if (found != 1) {
      fail("the header has " + std::to_string(found) + " elements \"vertex\"; expected one");
    }
    if (header_.elements[header_.vertex].count == 0) {
      file_.fail("the file has no points; expected at least one");
    }
    header_.data_offset = lines_.offset();
    header_.data_line = lines_.line() + 1;
  }

  const InputFile& file_;
  HeaderLines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

PlyHeader read_ply_header(const InputFile& file) { return PlyHeaderReader(file).read(); }

}  // namespace planescope::io
