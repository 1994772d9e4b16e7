// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtp_reader.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <span>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <zlib.h>

#include "vtp_xml.hpp"

namespace planescope::draw {
namespace {

constexpr std::uint64_t kZlibLargestRatio = 1032;

/// 0 to 63, or 64 for what is no digit of base64.
std::array<std::uint8_t, 256> digits() {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> table{};
  table.fill(64);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    table[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  return table;
}

/// The appended data, array by array.
class AppendedData {
 public:
  AppendedData(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// \throws Error{Kind::Input} the array at `offset` does not unpack to `size` bytes: asked before
  /// memory is taken for it.
  void require(std::uint64_t offset, std::uint64_t size) const {
    const Blocks blocks = blocks_at(offset);
    if (blocks.size() != size || size > blocks.packed() * kZlibLargestRatio)
      fail("an array has " + std::to_string(blocks.size()) + " bytes in " +
           std::to_string(blocks.packed()) + ", not " + std::to_string(size));
  }

  /// Fills `to` with the array at `offset`, which was asked for by require().
  void read(std::uint64_t offset, std::span<std::byte> to) const {
    const Blocks blocks = blocks_at(offset);
    const std::string bytes = decode(offset + encoded(4 * blocks.head.size()), blocks.packed());
    std::size_t from = 0, at = 0;
    for (std::size_t b = 3; b < blocks.head.size(); ++b) {
      const std::size_t want = std::min<std::size_t>(blocks.head[1], to.size() - at);
      uLongf got = want;
      const int status =
          ::uncompress(reinterpret_cast<Bytef*>(to.data() + at), &got,
                       reinterpret_cast<const Bytef*>(bytes.data() + from), blocks.head[b]);
      if (status != Z_OK || got != want) fail("an array is damaged: zlib does not unpack it");
      from += blocks.head[b];
      at += want;
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { refuse_vtp(name_, what); }

  /// Number of blocks, size of a block, size of the last one where it is smaller, packed sizes.
  struct Blocks {
    std::vector<std::uint32_t> head;

    /// Below 2^64: both factors are below 2^32.
    std::uint64_t size() const {
      const std::uint64_t full = head[0] - (head[2] > 0 ? 1U : 0U);
      return head[0] == 0 ? 0 : full * head[1] + head[2];
    }
    std::uint64_t packed() const {
      return std::accumulate(head.begin() + 3, head.end(), std::uint64_t{0});
    }
  };

  Blocks blocks_at(std::uint64_t offset) const {
    const std::uint64_t count = numbers(offset, 3)[0];
    return {numbers(offset, 3 + count)};
  }

  static std::uint64_t encoded(std::uint64_t bytes) { return (bytes + 2) / 3 * 4; }

  std::vector<std::uint32_t> numbers(std::uint64_t offset, std::uint64_t count) const {
    if (count > text_.size()) fail("an array has more blocks than the file has bytes");
    const std::string bytes = decode(offset, 4 * count);
    std::vector<std::uint32_t> values(count);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }

  /// `count` bytes from their digits at `offset`.
  std::string decode(std::uint64_t offset, std::uint64_t count) const {
    static const std::array<std::uint8_t, 256> kValue = digits();
    if (offset > text_.size() || encoded(count) > text_.size() - offset)
      fail("an array goes beyond the end of the file");
    std::string bytes(encoded(count) / 4 * 3, '\0');
    unsigned bits = 0;  // of all: the 64 of what is no digit stays
    const auto digit = [&](std::size_t i) {
      const auto c = static_cast<unsigned char>(text_[i]);
      if (c != '=') bits |= kValue[c];
      return static_cast<std::uint32_t>(kValue[c]) % 64;
    };
    char* out = bytes.data();
    for (std::size_t i = offset, end = offset + encoded(count); i < end; i += 4) {
      const std::uint32_t group =
          digit(i) << 18 | digit(i + 1) << 12 | digit(i + 2) << 6 | digit(i + 3);
      *out++ = static_cast<char>(group >> 16 & 255);
      *out++ = static_cast<char>(group >> 8 & 255);
      *out++ = static_cast<char>(group & 255);
    }
    if ((bits & 64) != 0) fail("the appended data are no base64");
    bytes.resize(count);
    return bytes;
  }

  std::string_view text_;
  const std::string& name_;
};

/// One file: its header, its data, and what VTK makes of them.
class VtpReader {
 public:
  VtpReader(std::string_view bytes, const std::string& name)
      : name_(name), header_(parse_vtp_header(bytes, name)), data_(header_.appended, name) {}

  vtkSmartPointer<vtkPolyData> read() {
    const std::uint64_t points = count("NumberOfPoints");
    const std::uint64_t cells = count("NumberOfVerts") + count("NumberOfLines") +
                                count("NumberOfStrips") + count("NumberOfPolys");
    auto result = vtkSmartPointer<vtkPolyData>::New();
    const auto& positions = header_.arrays["Points"];
    if (positions.size() != 1 || positions[0].components != 3)
      refuse_vtp(name_, "has no array of points in three dimensions");
    vtkNew<vtkPoints> all;
    all->SetData(array(positions[0], points));
    result->SetPoints(all);
    result->SetVerts(cells_of("Verts", "NumberOfVerts"));
    result->SetLines(cells_of("Lines", "NumberOfLines"));
    result->SetStrips(cells_of("Strips", "NumberOfStrips"));
    result->SetPolys(cells_of("Polys", "NumberOfPolys"));
    for (const VtpArray& a : header_.arrays["PointData"])
      result->GetPointData()->AddArray(array(a, points));
    for (const VtpArray& a : header_.arrays["CellData"])
      result->GetCellData()->AddArray(array(a, cells));
    return result;
  }

 private:
  /// Below 2^32: what the file holds at most is checked array by array.
  std::uint64_t count(const std::string& key) {
    const auto found = header_.counts.find(key);
    if (found == header_.counts.end() || found->second > 0xFFFFFFFFU)
      refuse_vtp(name_, key + " is missing, or more than the file can hold");
    return found->second;
  }

  vtkSmartPointer<vtkDataArray> array(const VtpArray& a, std::uint64_t tuples) {
    static const std::map<std::string, int, std::less<>> kTypes = {
        {"UInt8", VTK_UNSIGNED_CHAR}, {"Int32", VTK_INT},     {"UInt32", VTK_UNSIGNED_INT},
        {"Int64", VTK_TYPE_INT64},    {"Float32", VTK_FLOAT}, {"Float64", VTK_DOUBLE}};
    const auto type = kTypes.find(a.type);
    if (type == kTypes.end() || a.components < 1 || a.components > 9)
      refuse_vtp(name_, "an array has a type that we do not write");
    auto result = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type->second));
    result->SetName(a.name.c_str());
    result->SetNumberOfComponents(static_cast<int>(a.components));
    fill(*result, a.offset, tuples);
    return result;
  }

  void fill(vtkDataArray& array, std::uint64_t offset, std::uint64_t tuples) const {
    const std::uint64_t width = static_cast<std::uint64_t>(array.GetNumberOfComponents()) *
                                static_cast<std::uint64_t>(array.GetDataTypeSize());
    data_.require(offset, tuples * width);  // tuples are below 2^32
    array.SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    data_.read(offset, {static_cast<std::byte*>(array.GetVoidPointer(0)), tuples * width});
  }

  /// The file has the ends of the cells; VTK wants their beginnings, and the end of the last.
  vtkSmartPointer<vtkCellArray> cells_of(const std::string& section, const std::string& key) {
    const std::uint64_t cells = count(key);
    auto result = vtkSmartPointer<vtkCellArray>::New();
    if (cells == 0) return result;
    const auto ends = indices(section, "offsets", cells);
    const vtkTypeInt64 corners = ends->GetValue(static_cast<vtkIdType>(cells) - 1);
    if (corners < 0 || corners > 0xFFFFFFFF) refuse_vtp(name_, "a cell is not where the file says");
    vtkNew<vtkTypeInt64Array> offsets;
    offsets->SetNumberOfValues(static_cast<vtkIdType>(cells) + 1);
    offsets->SetValue(0, 0);
    for (vtkIdType i = 0; i < ends->GetNumberOfValues(); ++i)
      offsets->SetValue(i + 1, ends->GetValue(i));
    result->SetData(offsets, indices(section, "connectivity", static_cast<std::uint64_t>(corners)));
    return result;
  }

  vtkSmartPointer<vtkTypeInt64Array> indices(const std::string& section, const std::string& name,
                                             std::uint64_t size) {
    for (const VtpArray& a : header_.arrays[section]) {
      if (a.name != name || a.type != "Int64" || a.components != 1) continue;
      auto result = vtkSmartPointer<vtkTypeInt64Array>::New();
      fill(*result, a.offset, size);
      return result;
    }
    refuse_vtp(name_, "the cells have no `" + name + "` of 64-bit integers");
  }

  const std::string& name_;
  VtpHeader header_;
  AppendedData data_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> parse_vtp(const std::string& bytes, const std::string& name) {
  return VtpReader(bytes, name).read();
}

}  // namespace planescope::draw
