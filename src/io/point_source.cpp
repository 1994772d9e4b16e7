// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/point_source.hpp"

#include <algorithm>
#include <utility>

namespace planescope::io {

FileRecords::FileRecords(const InputFile& file, const std::vector<Field>& fields,
                         const Selection& selection, std::uint64_t begin, std::uint64_t stride,
                         bool swapped)
    : file_(file), begin_(begin), stride_(static_cast<std::size_t>(stride)), swapped_(swapped) {
  for (const std::size_t i : selection.used) {
    places_.push_back({fields[i].type, static_cast<std::size_t>(fields[i].offset)});
  }
}

std::vector<Column> FileRecords::block(std::size_t first, std::size_t count,
                                       Scratch& scratch) const {
  const std::size_t size = count * stride_;
  std::byte* records = scratch.reserve(size);
  file_.read_at(begin_ + std::uint64_t{first} * stride_, {records, size});
  std::vector<Column> columns;
  columns.reserve(places_.size());
  for (const Place& place : places_) {
    columns.push_back({place.type, records + place.offset, stride_, swapped_});
  }
  return columns;
}

std::size_t FileRecords::block_points() const noexcept {
  constexpr std::size_t kBlock = std::size_t{1} << 18;  // [byte] half of a small core's L2
  return std::clamp<std::size_t>(kBlock / stride_, 1, std::size_t{1} << 15);
}

MemoryColumns::MemoryColumns(const std::vector<Field>& fields, const Selection& selection,
                             std::size_t points) {
  std::size_t size = 0;
  for (const std::size_t i : selection.used) {
    columns_.push_back({fields[i].type, size, size_of(fields[i].type)});
    size += points * columns_.back().size;
  }
  bytes_ = std::make_unique_for_overwrite<std::byte[]>(size);
}

MemoryColumns::MemoryColumns(const std::vector<Field>& fields, const Selection& selection,
                             std::size_t points, std::unique_ptr<std::byte[]> bytes)
    : bytes_(std::move(bytes)) {
  for (const std::size_t i : selection.used) {
    columns_.push_back({fields[i].type, static_cast<std::size_t>(fields[i].offset) * points,
                        size_of(fields[i].type)});
  }
}

std::vector<Column> MemoryColumns::block(std::size_t first, std::size_t, Scratch&) const {
  std::vector<Column> columns;
  columns.reserve(columns_.size());
  for (const Piece& piece : columns_) {
    columns.push_back(
        {piece.type, bytes_.get() + piece.offset + first * piece.size, piece.size, false});
  }
  return columns;
}

}  // namespace planescope::io
