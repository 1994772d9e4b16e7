// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply_reader.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "io/byte_cursor.hpp"
#include "io/limits.hpp"
#include "io/ply_header.hpp"
#include "io/text_rows.hpp"

namespace planescope::io {
namespace {

/// Walks binary records one after the other: the only way where lists make them vary in size.
class RecordWalker {
 public:
  RecordWalker(const InputFile& file, const PlyElement& element, bool swapped, ByteCursor& cursor)
      : file_(file), element_(element), swapped_(swapped), cursor_(cursor) {
    // A list counts with its length alone, so this is the least; it bounds the number of records.
    cursor.require(element.count, element.stride,
                   "the element " + element.name + " of " + std::to_string(element.count));
  }

  void skip() {
    const std::string what = "the element " + element_.name;
    if (!element_.has_list) return cursor_.skip(element_.count, element_.stride, what);
    for (std::uint64_t i = 0; i < element_.count; ++i) {
      for (const Field& field : element_.properties) skip(field);
    }
  }

  /// Gathers the used fields of all records, each in its column.
  void gather(const Selection& selection, MemoryColumns& columns) {
    for (std::size_t i = 0; i < element_.count; ++i) {
      std::size_t column = 0;
      for (std::size_t k = 0; k < element_.properties.size(); ++k) {
        const Field& field = element_.properties[k];
        if (column == selection.used.size() || selection.used[column] != k) {
          skip(field);
          continue;
        }
        const std::span<const std::byte> number =
            cursor_.take(size_of(field.type), "the property " + field.name);
        std::byte* to = columns.at(column++, i);
        std::memcpy(to, number.data(), number.size());
        if (swapped_) std::reverse(to, to + number.size());
      }
    }
  }

 private:
  void skip(const Field& field) {
    std::uint64_t count = 1;
    if (field.list) {
      const std::uint64_t place = cursor_.offset();
      const std::byte* at = cursor_.take(size_of(*field.list), "the property " + field.name).data();
      count = visit(*field.list, [&]<class T>() { return length(load<T>(at, swapped_), place); });
    }
    cursor_.skip(count, size_of(field.type), "the property " + field.name);
  }

  template <class T>
  std::uint64_t length(T value, std::uint64_t place) const {
    if constexpr (std::is_signed_v<T>) {
      if (value < T{0}) {
        file_.fail_byte(place, "a list of the element " + element_.name +
                                   " has a negative length; the file is damaged");
      }
    }
    return static_cast<std::uint64_t>(value);
  }

  const InputFile& file_;
  const PlyElement& element_;
  bool swapped_;
  ByteCursor& cursor_;
};

Frame frame_of(const InputFile& file, const PlyElement& vertex) {
  if (vertex.count > std::numeric_limits<std::uint32_t>::max()) {
    file.fail("the element vertex has more points than 32 bits hold");
  }
  Frame frame;
  frame.points = static_cast<std::size_t>(vertex.count);
  frame.width = static_cast<std::uint32_t>(vertex.count);
  return frame;
}

Assembled read_ascii(const InputFile& file, const PlyHeader& header, const Selection& selection) {
  const PlyElement& vertex = header.elements[header.vertex];
  TextRows rows{
      .begin = header.data_offset, .first_line = header.data_line, .points = vertex.count};
  for (std::size_t i = 0; i < header.vertex; ++i) {
    const PlyElement& element = header.elements[i];
    if (element.properties.empty()) continue;       // has no lines
    if (element.count > file.size() - rows.skip) {  // a line has a byte at least
      file.fail_byte(file.size(), "the file ends here, before the " +
                                      std::to_string(element.count) + " lines of the element " +
                                      element.name + "; it is truncated or its header is wrong");
    }
    rows.skip += element.count;
  }
  for (std::size_t i = header.vertex + 1; i < header.elements.size(); ++i) {
    rows.may_go_on = rows.may_go_on || header.elements[i].count > 0;
  }
  const auto columns = read_text(file, vertex.properties, selection, rows);
  return assemble(file, *columns, selection, frame_of(file, vertex));
}

Assembled read_binary(const InputFile& file, const PlyHeader& header, const Selection& selection) {
  const bool swapped = header.format == PlyFormat::BigEndian;
  ByteCursor cursor(file, header.data_offset);
  for (std::size_t i = 0; i < header.vertex; ++i) {
    RecordWalker(file, header.elements[i], swapped, cursor).skip();
  }
  const PlyElement& vertex = header.elements[header.vertex];
  const Frame frame = frame_of(file, vertex);
  RecordWalker walker(file, vertex, swapped, cursor);
  if (vertex.has_list) {
    MemoryColumns columns(vertex.properties, selection, frame.points);
    walker.gather(selection, columns);
    return assemble(file, columns, selection, frame);
  }
  const FileRecords records(file, vertex.properties, selection, cursor.offset(), vertex.stride,
                            swapped);
  return assemble(file, records, selection, frame);
}

}  // namespace

Assembled read_ply(const InputFile& file, const ReadLimits& limits) {
  const PlyHeader header = read_ply_header(file);
  const PlyElement& vertex = header.elements[header.vertex];
  check_limits(file, vertex.count, limits);
  const Selection selection = select_fields(file, vertex.properties);
  return header.format == PlyFormat::Ascii ? read_ascii(file, header, selection)
                                           : read_binary(file, header, selection);
}

}  // namespace planescope::io
