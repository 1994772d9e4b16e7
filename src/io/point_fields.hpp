// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/input_file.hpp"
#include "io/scalar.hpp"

/// \file What the fields of a point record are called, and which of them a cloud is made from.
namespace planescope::io {

/// One field of a point record, as a PCD or PLY header declares it.
struct Field {
  std::string name;
  Scalar type = Scalar::F32;
  std::uint64_t count = 1;     ///< numbers; of a list: not known before the record is read
  std::uint64_t offset = 0;    ///< [byte] in a record without lists
  std::optional<Scalar> list;  ///< type of the length, where the field is a PLY list
};

/// What a field is to a cloud.
enum class Role : std::uint8_t {
  X,
  Y,
  Z,       ///< float or double, required
  Packed,  ///< rgb or rgba: 0xAARRGGBB in four bytes of any type
  Red,
  Green,
  Blue,  ///< 8 bits, 16 bits (scaled), or real in [0, 1]
  NormalX,
  NormalY,
  NormalZ,     ///< float or double
  Label,       ///< a whole number in [0, 2^32)
  Radius,      ///< any number
  Confidence,  ///< any number
};
inline constexpr std::size_t kRoles = 13;

/// The fields that are read, as indices into the header's fields; `role` and `extra` are indices
/// into `used`, which is in the order of the header.
struct Selection {
  std::vector<std::size_t> used;
  std::array<std::optional<std::size_t>, kRoles> role;
  std::vector<std::size_t> extra;  ///< in the order in which they were asked for

  bool has(Role r) const noexcept { return role[static_cast<std::size_t>(r)].has_value(); }
};

/// Finds the fields a cloud is made from, and those named in `extra` (32-bit integer columns).
/// Names: x y z; rgb | rgba, else red green blue; normal_x normal_y normal_z | nx ny nz; label;
/// radius; confidence.
/// \throws Error{Kind::Input} x, y or z is missing; a field that is used appears twice, or has a
/// type or count that its role does not allow; a colour or normal is incomplete; an extra is
/// missing or no integer.
Selection select_fields(const InputFile& file, const std::vector<Field>& fields,
                        const std::vector<std::string>& extra = {});

}  // namespace planescope::io
