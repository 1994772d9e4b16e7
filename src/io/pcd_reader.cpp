// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_reader.hpp"

#include <array>
#include <memory>
#include <span>

#include "io/byte_cursor.hpp"
#include "io/limits.hpp"
#include "io/lzf.hpp"
#include "io/pcd_header.hpp"
#include "io/text_rows.hpp"

namespace planescope::io {
namespace {

/// A cloud of one column is a list that someone wrote upright: nothing is next to anything in it.
Frame frame_of(const PcdHeader& header) {
  Frame frame;
  frame.points = static_cast<std::size_t>(header.points);
  const bool image = header.width > 1;
  frame.width = static_cast<std::uint32_t>(image ? header.width : header.points);
  frame.height = image ? static_cast<std::uint32_t>(header.height) : 1;
  frame.viewpoint = header.viewpoint;
  return frame;
}

std::unique_ptr<std::byte[]> read_bytes(const InputFile& file, std::uint64_t offset,
                                        std::size_t size) {
  auto bytes = std::make_unique_for_overwrite<std::byte[]>(size);
  file.read_at(offset, {bytes.get(), size});
  return bytes;
}

/// The data of binary_compressed: two sizes, then LZF over the fields one after the other. Both
/// sizes are held against the header and the file before memory is taken for either.
std::unique_ptr<std::byte[]> expand(const InputFile& file, const PcdHeader& header) {
  ByteCursor cursor(file, header.data_offset);
  const auto size = [&](const char* what) {
    return std::uint64_t{load<std::uint32_t>(cursor.take(4, what).data())};
  };
  const std::uint64_t compressed = size("the compressed size");
  const std::uint64_t expanded = size("the expanded size");
  const auto expected = checked_product(header.points, header.stride);
  if (!expected || *expected != expanded) {
    file.fail_byte(cursor.offset() - 4, "the expanded size is " + std::to_string(expanded) +
                                            ", but the header's " + std::to_string(header.points) +
                                            " points of " + std::to_string(header.stride) +
                                            " bytes need another; the file is damaged");
  }
  cursor.require(compressed, 1, "the compressed data");
  if (expanded > compressed * kLzfLargestRatio) {
    file.fail_byte(cursor.offset(), std::to_string(compressed) + " bytes of LZF cannot expand to " +
                                        std::to_string(expanded) + "; the file is damaged");
  }
  const auto from = read_bytes(file, cursor.offset(), static_cast<std::size_t>(compressed));
  auto to = std::make_unique_for_overwrite<std::byte[]>(static_cast<std::size_t>(expanded));
  if (const auto failure = lzf_expand({from.get(), static_cast<std::size_t>(compressed)},
                                      {to.get(), static_cast<std::size_t>(expanded)})) {
    file.fail_byte(cursor.offset() + failure->offset, failure->what + "; the file is damaged");
  }
  return to;
}

}  // namespace

Assembled read_pcd(const InputFile& file, const ReadLimits& limits,
                   const std::vector<std::string>& extra,
                   const std::optional<Eigen::Vector3d>& origin) {
  const PcdHeader header = read_pcd_header(file);
  check_limits(file, header.points, limits);
  const Selection selection = select_fields(file, header.fields, extra);
  const Frame frame = frame_of(header);
  if (header.data == PcdData::Ascii) {
    const TextRows rows{
        .begin = header.data_offset, .first_line = header.data_line, .points = header.points};
    return assemble(file, *read_text(file, header.fields, selection, rows), selection, frame,
                    origin);
  }
  if (header.data == PcdData::Compressed) {
    const MemoryColumns columns(header.fields, selection, frame.points, expand(file, header));
    return assemble(file, columns, selection, frame, origin);
  }
  ByteCursor(file, header.data_offset)
      .require(header.points, header.stride, "POINTS " + std::to_string(header.points));
  const FileRecords records(file, header.fields, selection, header.data_offset, header.stride,
                            false);
  return assemble(file, records, selection, frame, origin);
}

Assembled read_pcd_columns(const std::filesystem::path& file, const std::vector<std::string>& extra,
                           const std::optional<Eigen::Vector3d>& origin, const ReadLimits& limits) {
  return read_pcd(InputFile(file), limits, extra, origin);
}

}  // namespace planescope::io
