// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/decode.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace planescope::io {
namespace {

/// Calls f(i, value) for each number of a column that has type T.
template <class T, class F>
void each(const Column& column, std::size_t count, F f) {
  const std::byte* at = column.data;
  if (column.swapped) {
    for (std::size_t i = 0; i < count; ++i, at += column.stride) f(i, load<T>(at, true));
  } else {
    for (std::size_t i = 0; i < count; ++i, at += column.stride) f(i, load<T>(at));
  }
}

/// The same for float or double.
template <class F>
void each_real(const Column& column, std::size_t count, F f) {
  if (column.type == Scalar::F64) {
    each<double>(column, count, f);
  } else {
    each<float>(column, count, f);
  }
}

const Column& of(const std::vector<Column>& columns, const Selection& selection, Role role,
                 std::size_t step = 0) {
  return columns[*selection.role[static_cast<std::size_t>(role) + step]];
}

/// Three floats side by side in this machine's byte order: a point is 12 bytes to copy.
bool is_float_triple(const Column& x, const Column& y, const Column& z) {
  const auto fits = [&](const Column& c, std::size_t step) {
    return c.type == Scalar::F32 && !c.swapped && c.stride == x.stride && c.data == x.data + step;
  };
  return fits(x, 0) && fits(y, 4) && fits(z, 8);
}

void decode_vectors(const std::array<Column, 3>& columns, const Eigen::Vector3d& origin,
                    std::span<Eigen::Vector3f> vectors) {
  if (origin.isZero(0) && is_float_triple(columns[0], columns[1], columns[2])) {
    const std::byte* at = columns[0].data;
    for (Eigen::Vector3f& vector : vectors) {
      std::memcpy(vector.data(), at, sizeof(float) * 3);
      at += columns[0].stride;
    }
    return;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double shift = origin[axis];
    each_real(columns[static_cast<std::size_t>(axis)], vectors.size(), [&](std::size_t i, auto v) {
      vectors[i][axis] = static_cast<float>(double{v} - shift);
    });
  }
}

std::uint8_t to_channel(std::uint8_t value) { return value; }
std::uint8_t to_channel(std::uint16_t value) {
  return static_cast<std::uint8_t>((value * 255U + 32767U) / 65535U);
}
std::uint8_t to_channel(double value) {
  if (!(value > 0)) return 0;  // NaN too
  return static_cast<std::uint8_t>(std::lround(std::min(value, 1.0) * 255));
}

template <class T>
void decode_channel(const Column& column, std::span<Rgb> colors, std::uint8_t Rgb::*channel) {
  each<T>(column, colors.size(),
          [&](std::size_t i, T value) { colors[i].*channel = to_channel(value); });
}

}  // namespace

std::size_t decode_positions(const std::vector<Column>& columns, const Selection& selection,
                             const Eigen::Vector3d& origin, std::span<Eigen::Vector3f> positions) {
  decode_vectors({of(columns, selection, Role::X), of(columns, selection, Role::Y),
                  of(columns, selection, Role::Z)},
                 origin, positions);
  std::size_t finite = 0;
  for (const Eigen::Vector3f& p : positions) finite += is_finite(p) ? 1 : 0;
  return finite;
}

void decode_colors(const std::vector<Column>& columns, const Selection& selection,
                   std::span<Rgb> colors) {
  if (selection.has(Role::Packed)) {
    each<std::uint32_t>(of(columns, selection, Role::Packed), colors.size(),
                        [&](std::size_t i, std::uint32_t bits) {
                          colors[i] = {static_cast<std::uint8_t>(bits >> 16),
                                       static_cast<std::uint8_t>(bits >> 8),
                                       static_cast<std::uint8_t>(bits)};
                        });
    return;
  }
  constexpr std::array<std::uint8_t Rgb::*, 3> channels = {&Rgb::r, &Rgb::g, &Rgb::b};
  for (std::size_t c = 0; c < 3; ++c) {
    const Column& column = of(columns, selection, Role::Red, c);
    if (column.type == Scalar::U8) decode_channel<std::uint8_t>(column, colors, channels[c]);
    if (column.type == Scalar::U16) decode_channel<std::uint16_t>(column, colors, channels[c]);
    if (column.type == Scalar::F32) decode_channel<float>(column, colors, channels[c]);
    if (column.type == Scalar::F64) decode_channel<double>(column, colors, channels[c]);
  }
}

void decode_normals(const std::vector<Column>& columns, const Selection& selection,
                    std::span<Eigen::Vector3f> normals) {
  constexpr double kUnit = 1e-3;
  decode_vectors({of(columns, selection, Role::NormalX), of(columns, selection, Role::NormalY),
                  of(columns, selection, Role::NormalZ)},
                 Eigen::Vector3d::Zero(), normals);
  for (Eigen::Vector3f& normal : normals) {
    const double length = normal.cast<double>().norm();
    if (std::abs(length - 1) <= kUnit) continue;
    if (length > 0 && std::isfinite(length)) {
      normal = (normal.cast<double>() / length).cast<float>();
    } else {
      normal.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
  }
}

void decode_numbers(const Column& column, bool positive, std::span<float> values) {
  visit(column.type, [&]<class From>() {
    each<From>(column, values.size(), [&](std::size_t i, From number) {
      const auto value = static_cast<double>(number);
      constexpr double kMost = double{std::numeric_limits<float>::max()};
      const bool known = std::abs(value) <= kMost && (!positive || value > 0);  // false for NaN
      values[i] = known ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
    });
  });
}

template <class T>
std::optional<std::size_t> decode_whole(const Column& column, std::span<T> values) {
  std::optional<std::size_t> bad;
  visit(column.type, [&]<class From>() {
    each<From>(column, values.size(), [&](std::size_t i, From value) {
      bool fits = false;
      if constexpr (std::is_integral_v<From>) {
        fits = std::in_range<T>(value);
      } else {  // false for NaN
        fits = value >= From(std::numeric_limits<T>::min()) &&
               double{value} <= double{std::numeric_limits<T>::max()} && std::trunc(value) == value;
      }
      values[i] = fits ? static_cast<T>(value) : T{0};
      if (!fits && !bad) bad = i;
    });
  });
  return bad;
}

template std::optional<std::size_t> decode_whole(const Column&, std::span<std::uint32_t>);
template std::optional<std::size_t> decode_whole(const Column&, std::span<std::int32_t>);

}  // namespace planescope::io
