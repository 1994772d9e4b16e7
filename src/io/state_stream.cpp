// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/state_stream.hpp"

#include <algorithm>
#include <array>
#include <istream>
#include <ostream>
#include <utility>

#include "planescope/error.hpp"

namespace planescope::io {
namespace {

constexpr std::uint32_t kByteOrder = 0x01020304;

std::array<char, 8> padded(std::string_view name) {
  std::array<char, 8> text{};
  std::copy_n(name.begin(), std::min(name.size(), text.size()), text.begin());
  return text;
}

}  // namespace

void StateHash::add(const void* bytes, std::size_t size) {
  const auto* from = static_cast<const unsigned char*>(bytes);
  for (; size > 0;) {
    const std::size_t part = std::min<std::size_t>(size, 8);
    std::uint64_t word = 0;
    std::memcpy(&word, from, part);
    value_ = (value_ ^ word) * 0x100000001b3ull;
    value_ ^= value_ >> 32;
    from += part, size -= part;
  }
}

StateWriter::StateWriter(std::ostream& to, std::string_view name, std::uint32_t version) : to_(to) {
  const std::array<char, 8> title = padded(name);
  bytes(title.data(), title.size());
  put(version);
  put(kByteOrder);
}

void StateWriter::bytes(const void* data, std::size_t size) {
  if (size == 0) return;
  hash_.add(data, size);
  to_.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

void StateWriter::finish() {
  const std::uint64_t value = hash_.value();
  to_.write(reinterpret_cast<const char*>(&value), sizeof value);
}

StateReader::StateReader(std::istream& from, std::string file, std::string_view name,
                         std::uint32_t version)
    : from_(from), file_(std::move(file)) {
  const auto here = from_.tellg();
  from_.seekg(0, std::ios::end);
  const auto end = from_.tellg();
  from_.seekg(here);
  if (here < 0 || end < here) fail("cannot be read");
  at_ = static_cast<std::uint64_t>(here);
  size_ = static_cast<std::uint64_t>(end);
  std::array<char, 8> title{};
  bytes(title.data(), title.size());
  if (title != padded(name))
    fail("is no snapshot of planescope (expected `" + std::string(name) + "`)");
  const auto found = get<std::uint32_t>();
  if (get<std::uint32_t>() != kByteOrder) fail("was written by a machine of another byte order");
  if (found != version) {
    fail("has version " + std::to_string(found) + ", this planescope reads " +
         std::to_string(version) + "; begin again without it");
  }
}

void StateReader::bytes(void* data, std::size_t size) {
  if (size == 0) return;
  if (size > size_ - at_) fail("is cut short");
  from_.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
  if (!from_) fail("cannot be read");
  hash_.add(data, size);
  at_ += size;
}

std::size_t StateReader::length(std::size_t least) {
  const auto count = get<std::uint64_t>();
  if (count > (size_ - at_) / std::max<std::size_t>(1, least)) fail("is cut short or damaged");
  return static_cast<std::size_t>(count);
}

std::string StateReader::text() {
  std::string text(length(1), '\0');
  bytes(text.data(), text.size());
  return text;
}

void StateReader::finish() {
  const std::uint64_t expected = hash_.value();
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION  // fuzzing does not guess hashes
  constexpr bool kChecked = false;
#else
  constexpr bool kChecked = true;
#endif
  if (get<std::uint64_t>() != expected && kChecked) fail("is damaged: its hash differs");
}

void StateReader::fail(const std::string& what) const {
  throw Error(Error::Kind::Input, file_ + ": byte " + std::to_string(at_) + ": " + what);
}

}  // namespace planescope::io
