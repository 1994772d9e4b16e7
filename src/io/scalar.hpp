// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>

/// \file The ten number types of PCD and PLY files, and how one of them is taken from bytes.
namespace planescope::io {

// The writers store numbers as they lie in memory, and the files they write are little-endian.
static_assert(std::endian::native == std::endian::little,
              "a big-endian host needs a byte swap in the writers");

/// A number type: signed and unsigned integers of 8 to 64 bits, float, double.
enum class Scalar : std::uint8_t { I8, U8, I16, U16, I32, U32, I64, U64, F32, F64 };

/// Bytes of one number.
constexpr std::size_t size_of(Scalar type) noexcept {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

/// In words for messages: "signed 8-bit integers", "floats".
constexpr const char* words(Scalar type) noexcept {
  constexpr std::array<const char*, 10> names = {"signed 8-bit integers",
                                                 "unsigned 8-bit integers",
                                                 "signed 16-bit integers",
                                                 "unsigned 16-bit integers",
                                                 "signed 32-bit integers",
                                                 "unsigned 32-bit integers",
                                                 "signed 64-bit integers",
                                                 "unsigned 64-bit integers",
                                                 "floats",
                                                 "doubles"};
  return names[static_cast<std::size_t>(type)];
}

/// True for float and double.
constexpr bool is_real(Scalar type) noexcept { return type == Scalar::F32 || type == Scalar::F64; }

/// Calls visitor.operator()<T>() with the C++ type of `type`, once, so that a loop over a million
/// numbers decides their type outside of itself.
template <class Visitor>
decltype(auto) visit(Scalar type, Visitor&& visitor) {
  switch (type) {
    case Scalar::I8:
      return visitor.template operator()<std::int8_t>();
    case Scalar::U8:
      return visitor.template operator()<std::uint8_t>();
    case Scalar::I16:
      return visitor.template operator()<std::int16_t>();
    case Scalar::U16:
      return visitor.template operator()<std::uint16_t>();
    case Scalar::I32:
      return visitor.template operator()<std::int32_t>();
    case Scalar::U32:
      return visitor.template operator()<std::uint32_t>();
    case Scalar::I64:
      return visitor.template operator()<std::int64_t>();
    case Scalar::U64:
      return visitor.template operator()<std::uint64_t>();
    case Scalar::F32:
      return visitor.template operator()<float>();
    case Scalar::F64:
      break;
  }
  return visitor.template operator()<double>();
}

/// One number from bytes that need no alignment; `swapped`: they are in the other byte order.
template <class T>
T load(const std::byte* at, bool swapped = false) noexcept {
  std::array<std::byte, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

/// a * b, or nothing where 64 bits do not hold it.
inline std::optional<std::uint64_t> checked_product(std::uint64_t a, std::uint64_t b) noexcept {
  std::uint64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
  return product;
}

}  // namespace planescope::io
