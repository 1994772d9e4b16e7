// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "io/scalar.hpp"

/// \file The one place where untrusted bytes are walked in order: no step leaves the file.
namespace planescope::io {

/// Walks a file from front to back through a small window.
class ByteCursor {
 public:
  static constexpr std::size_t kWindow = std::size_t{1} << 16;  ///< [byte] longest take() or line

  /// Starts at `begin`, which must not lie beyond the end. The file must outlive the cursor.
  explicit ByteCursor(const InputFile& file, std::uint64_t begin = 0);

  std::uint64_t offset() const noexcept { return offset_; }
  std::uint64_t remaining() const noexcept { return file_.size() - offset_; }

  /// \throws Error{Kind::Input} fewer than `count` * `size` bytes remain (or 64 bits do not hold
  /// the product): says that `what` needs them.
  void require(std::uint64_t count, std::uint64_t size, const std::string& what) const;

  /// The next `size` bytes, at most kWindow; valid until the next call.
  /// \throws Error{Kind::Input} they are not there.
  std::span<const std::byte> take(std::size_t size, const std::string& what);

  /// Passes over `count` * `size` bytes without reading them.
  /// \throws Error{Kind::Input} they are not there.
  void skip(std::uint64_t count, std::uint64_t size, const std::string& what);

  /// The next line without its end (LF or CRLF), or nothing at the end of the file; valid until the
  /// next call. \throws Error{Kind::Input} no line end within kWindow bytes.
  std::optional<std::string_view> line();

 private:
  void refill();
  std::size_t buffered() const noexcept { return filled_ - start_; }

  const InputFile& file_;
  std::uint64_t offset_;           ///< of the next byte in the file
  std::vector<std::byte> window_;  ///< [start_, filled_) are the bytes from offset_ on
  std::size_t start_ = 0, filled_ = 0;
};

/// The lines of a header: counted, and at most 64 kB of them.
class HeaderLines {
 public:
  static constexpr std::uint64_t kLimit = std::uint64_t{1} << 16;  ///< [byte]

  explicit HeaderLines(const InputFile& file) : file_(file), cursor_(file) {}

  /// The next line's words; empty for a blank line. Valid until the next call.
  /// \throws Error{Kind::Input} the file ends, or the header goes beyond kLimit, before `last`
  /// (such as "end_header") was seen.
  const std::vector<std::string_view>& next(const char* last);

  std::uint64_t line() const noexcept { return line_; }  ///< number of the last line, from 1
  std::uint64_t offset() const noexcept { return cursor_.offset(); }  ///< of the byte after it

 private:
  const InputFile& file_;
  ByteCursor cursor_;
  std::uint64_t line_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace planescope::io
