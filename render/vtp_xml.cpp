// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtp_xml.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/numbers.hpp"
#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

/// <name key="value" ...>; `closed` where it ends by "/>" or is a "</name>".
struct Tag {
  std::string_view name;
  std::vector<std::pair<std::string_view, std::string_view>> attributes;
  bool opens = true, closes = false;

  std::string_view at(std::string_view key) const {
    for (const auto& [k, value] : attributes)
      if (k == key) return value;
    return {};
  }
};

/// Walks the tags from front to back; text between them is passed over.
class Tags {
 public:
  Tags(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  Tag next() {
    at_ = bytes_.find('<', at_);
    const std::size_t end = at_ == std::string_view::npos ? at_ : bytes_.find('>', at_);
    if (end == std::string_view::npos) refuse_vtp(name_, "ends inside its XML");
    constexpr std::size_t kLongest = 4096;
    if (end - at_ > kLongest) refuse_vtp(name_, where() + "an element is longer than 4096 bytes");
    std::string_view text = bytes_.substr(at_ + 1, end - at_ - 1);
    Tag tag;
    if (text.starts_with('/')) {
      tag.opens = false;
      tag.closes = true;
      text.remove_prefix(1);
    } else if (text.ends_with('/') || text.starts_with('?')) {
      tag.closes = true;
      text.remove_suffix(1);
    }
    tag.name = word(text);
    while (!text.empty()) tag.attributes.push_back(attribute(text));
    at_ = end + 1;
    return tag;
  }

  std::string_view rest() const { return bytes_.substr(at_); }
  std::string where() const { return "byte " + std::to_string(at_) + ": "; }

 private:
  /// The word up to a blank or '='; blanks after it are passed over.
  static std::string_view word(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n="), text.size());
    const std::string_view found = text.substr(0, end);
    text.remove_prefix(std::min(text.find_first_not_of(kBlank, end), text.size()));
    return found;
  }

  std::pair<std::string_view, std::string_view> attribute(std::string_view& text) const {
    const std::string_view key = word(text);
    const std::size_t end = text.starts_with("=\"") ? text.find('"', 2) : std::string_view::npos;
    if (key.empty() || end == std::string_view::npos)
      refuse_vtp(name_, where() + "an attribute is not understood");
    const std::string_view value = text.substr(2, end - 2);
    text.remove_prefix(std::min(text.find_first_not_of(kBlank, end + 1), text.size()));
    return {key, value};
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
};

/// A number, padded by blanks as the writer does that comes back to fill it in.
std::uint64_t number(std::string_view text, const Tags& tags, const std::string& name) {
  const auto value = io::parse_word<std::uint64_t>(text);
  if (!value) refuse_vtp(name, tags.where() + "a count or offset is no whole number");
  return *value;
}

void expect(const Tag& tag, std::string_view key, std::string_view value, const Tags& tags,
            const std::string& name) {
  if (tag.at(key) == value) return;
  refuse_vtp(name, tags.where() + std::string(key) + " is not `" + std::string(value) + "`");
}

bool is_section(std::string_view name) {
  constexpr std::array<std::string_view, 7> kSections = {"PointData", "CellData", "Points", "Verts",
                                                         "Lines",     "Strips",   "Polys"};
  return std::ranges::find(kSections, name) != kSections.end();
}

VtpArray array_of(const Tag& tag, const Tags& tags, const std::string& name) {
  expect(tag, "format", "appended", tags, name);
  VtpArray array{std::string(tag.at("type")), std::string(tag.at("Name"))};
  if (!tag.at("NumberOfComponents").empty())
    array.components = number(tag.at("NumberOfComponents"), tags, name);
  array.offset = number(tag.at("offset"), tags, name);
  return array;
}

}  // namespace

void refuse_vtp(const std::string& name, const std::string& what) {
  throw Error(Error::Kind::Input,
              name + ": " + what + "; segment the scene again to make the folder anew");
}

VtpHeader parse_vtp_header(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kMostArrays = 100;
  VtpHeader header;
  Tags tags(bytes, name);
  std::string section;
  bool file = false, piece = false;
  for (std::size_t arrays = 0; arrays < kMostArrays;) {
    const Tag tag = tags.next();
    if (tag.name == "VTKFile" && tag.opens) {
      expect(tag, "type", "PolyData", tags, name);
      expect(tag, "byte_order", "LittleEndian", tags, name);
      expect(tag, "header_type", "UInt32", tags, name);
      expect(tag, "compressor", "vtkZLibDataCompressor", tags, name);
      file = true;
    } else if (tag.name == "Piece" && tag.opens && file && !std::exchange(piece, true)) {
      for (const auto& [key, value] : tag.attributes)
        header.counts[std::string(key)] = number(value, tags, name);
    } else if (is_section(tag.name)) {
      section = tag.opens && !tag.closes ? tag.name : "";
    } else if (tag.name == "DataArray" && tag.opens && !section.empty()) {
      header.arrays[section].push_back(array_of(tag, tags, name));
      ++arrays;
    } else if (tag.name == "AppendedData" && tag.opens && piece) {
      expect(tag, "encoding", "base64", tags, name);
      const std::string_view rest = tags.rest();
      const std::size_t begin = rest.find('_'), end = rest.find('<');
      if (begin == std::string_view::npos || end == std::string_view::npos || end < begin)
        refuse_vtp(name, tags.where() + "the appended data have no beginning or no end");
      header.appended = rest.substr(begin + 1, end - begin - 1);
      return header;
    } else if (tag.opens && tag.name != "PolyData" && tag.name != "InformationKey" &&
               tag.name != "Value" && tag.name != "?xml") {
      refuse_vtp(name, tags.where() + "an element that does not belong here");
    }
  }
  refuse_vtp(name, "has more than 100 arrays");
}

}  // namespace planescope::draw
