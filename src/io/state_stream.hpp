// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "planescope/cloud.hpp"

/// \file Snapshots: sections of plain values, one after the other, in the byte order of the machine
/// that wrote them (a file of another order is refused). A section is
///   8 bytes   its name, padded with zeros
///   4 bytes   its version
///   4 bytes   0x01020304: the byte order
///   ...       values as they are written; lists and texts as their length (8 bytes) and elements
///   8 bytes   a hash of all of the above: of each value or list, a word of 8 bytes at a time (the
///             last one padded with zeros): h = (h ^ word) * 0x100000001b3, h ^= h >> 32; h
///             begins as 0xcbf29ce484222325 (FNV-1a, with a shift so that high bits come down)
namespace planescope::io {

/// The hash behind a section.
class StateHash {
 public:
  void add(const void* bytes, std::size_t size);
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// What can be written byte by byte.
template <class T>
concept Plain =
    std::is_arithmetic_v<T> || std::is_same_v<T, Eigen::Vector3f> || std::is_same_v<T, Rgb>;

class StateWriter {
 public:
  /// Begins a section; `name` has at most 8 letters. The stream must outlive the writer.
  StateWriter(std::ostream& to, std::string_view name, std::uint32_t version);

  template <Plain T>
  void put(const T& value) {
    bytes(&value, sizeof(T));
  }
  template <Plain T>
  void list(std::span<const T> values) {
    put<std::uint64_t>(values.size());
    bytes(values.data(), values.size_bytes());
  }
  template <Plain T>
  void list(const std::vector<T>& values) {
    list(std::span<const T>(values));
  }
  void text(std::string_view text) { list(std::span<const char>(text)); }

  void finish();  ///< ends the section with its hash

 private:
  void bytes(const void* data, std::size_t size);

  std::ostream& to_;
  StateHash hash_;
};

/// Reads a section back, untrusted: no list is longer than the bytes that are left.
class StateReader {
 public:
  /// \throws Error{Kind::Input} another section, version or byte order. \param file for messages.
  StateReader(std::istream& from, std::string file, std::string_view name, std::uint32_t version);

  template <Plain T>
  T get() {
    T value;
    bytes(&value, sizeof(T));
    return value;
  }
  template <Plain T>
  std::vector<T> list() {
    std::vector<T> values(length(sizeof(T)));
    bytes(values.data(), values.size() * sizeof(T));
    return values;
  }
  std::string text();

  /// The length of a list of which each element takes at least `least` bytes.
  /// \throws Error{Kind::Input} the stream does not hold as many.
  std::size_t length(std::size_t least);

  /// Checks the section's hash. \throws Error{Kind::Input} it differs.
  void finish();

  /// \throws Error{Kind::Input} always: the file is damaged, and where.
  [[noreturn]] void fail(const std::string& what) const;
  void require(bool holds, const char* what) const {
    if (!holds) fail(what);
  }

 private:
  void bytes(void* data, std::size_t size);

  std::istream& from_;
  std::string file_;
  std::uint64_t size_ = 0, at_ = 0;  ///< [byte] of the stream; of the next value
  StateHash hash_;
};

}  // namespace planescope::io
