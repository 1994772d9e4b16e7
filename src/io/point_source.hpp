// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "io/input_file.hpp"
#include "io/point_fields.hpp"
#include "io/scalar.hpp"

/// \file Where the numbers of points lie: in the file's records, or in columns in memory. Both give
/// them out block by block as strided columns, so that one decoder serves every format.
namespace planescope::io {

/// Numbers of one type at a fixed stride.
struct Column {
  Scalar type = Scalar::F32;
  const std::byte* data = nullptr;
  std::size_t stride = 0;  ///< [byte]
  bool swapped = false;    ///< in the other byte order
};

/// Memory that blocks are read into; one for each thread, used again from block to block.
class Scratch {
 public:
  /// At least `size` bytes, not initialised.
  std::byte* reserve(std::size_t size) {
    if (size > size_) bytes_ = std::make_unique_for_overwrite<std::byte[]>(size_ = size);
    return bytes_.get();
  }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// The points of a file, any block of them at any time, from any thread.
class PointSource {
 public:
  PointSource() = default;
  virtual ~PointSource() = default;
  PointSource(const PointSource&) = delete;
  PointSource& operator=(const PointSource&) = delete;

  /// The used fields (in the order of Selection::used) of points [first, first + count), which must
  /// be in range; valid until `scratch` is used again. \throws Error{Kind::Input} reading fails.
  virtual std::vector<Column> block(std::size_t first, std::size_t count,
                                    Scratch& scratch) const = 0;
  /// Points in a block that keeps a block within a core's cache.
  virtual std::size_t block_points() const noexcept = 0;
};

/// Records of fixed size that lie one after the other in a file.
class FileRecords final : public PointSource {
 public:
  /// `begin`: offset of the first record; `stride`: bytes of a record.
  FileRecords(const InputFile& file, const std::vector<Field>& fields, const Selection& selection,
              std::uint64_t begin, std::uint64_t stride, bool swapped);
  std::vector<Column> block(std::size_t first, std::size_t count, Scratch& scratch) const override;
  std::size_t block_points() const noexcept override;

 private:
  struct Place {
    Scalar type;
    std::size_t offset;
  };
  const InputFile& file_;
  std::vector<Place> places_;
  std::uint64_t begin_;
  std::size_t stride_;
  bool swapped_;
};

/// Columns in memory, each in one piece: expanded, or parsed from text, or gathered from records of
/// varying size.
class MemoryColumns final : public PointSource {
 public:
  /// Columns for `points` numbers of each used field, to be filled through at().
  MemoryColumns(const std::vector<Field>& fields, const Selection& selection, std::size_t points);
  /// Takes bytes in which every field of `fields` lies in one piece, one after the other (expanded
  /// binary_compressed PCD).
  MemoryColumns(const std::vector<Field>& fields, const Selection& selection, std::size_t points,
                std::unique_ptr<std::byte[]> bytes);

  /// Where the number of used field `column` of point `point` lies.
  std::byte* at(std::size_t column, std::size_t point) noexcept {
    return bytes_.get() + columns_[column].offset + point * columns_[column].size;
  }
  std::vector<Column> block(std::size_t first, std::size_t count, Scratch& scratch) const override;
  std::size_t block_points() const noexcept override { return std::size_t{1} << 15; }

 private:
  struct Piece {
    Scalar type;
    std::size_t offset, size;  ///< [byte] of the first number; of one number
  };
  std::vector<Piece> columns_;
  std::unique_ptr<std::byte[]> bytes_;
};

}  // namespace planescope::io
