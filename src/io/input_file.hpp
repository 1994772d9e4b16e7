// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

/// \file A file as readers see it: a known number of bytes, read at any offset from any thread.
namespace planescope::io {

/// Read-only bytes of known length. Reading copies (pread) rather than maps: a file that another
/// program cuts short meanwhile gives an error, where a map would end the process by SIGBUS, and a
/// block that was just copied is decoded from the cache.
class InputFile {
 public:
  /// \param expected what kind of file it should be, for messages.
  /// \throws Error{Kind::Input} missing, not a regular file, unreadable, or empty.
  explicit InputFile(const std::filesystem::path& file,
                     const std::string& expected = "a PCD or PLY file");
  /// Bytes in memory under a name for messages; they must outlive the object. For tests and
  /// fuzzing. \throws Error{Kind::Input} no bytes.
  InputFile(std::string name, std::span<const std::byte> bytes);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& name() const noexcept { return name_; }
  std::uint64_t size() const noexcept { return size_; }

  /// Fills `to` from `offset` on. Safe from several threads at once.
  /// \throws Error{Kind::Input} the bytes are not all there, or the disk fails.
  void read_at(std::uint64_t offset, std::span<std::byte> to) const;

  /// \throws Error{Kind::Input} always: "<name>: <what>".
  [[noreturn]] void fail(const std::string& what) const;
  /// \throws Error{Kind::Input} always: "<name>: line <line>: <what>".
  [[noreturn]] void fail_line(std::uint64_t line, const std::string& what) const;
  /// \throws Error{Kind::Input} always: "<name>: byte <offset>: <what>".
  [[noreturn]] void fail_byte(std::uint64_t offset, const std::string& what) const;

 private:
  std::string name_;
  std::uint64_t size_ = 0;
  int descriptor_ = -1;  ///< or, where it is -1:
  std::span<const std::byte> memory_;
};

}  // namespace planescope::io
