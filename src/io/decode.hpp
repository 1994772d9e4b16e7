// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "io/point_fields.hpp"
#include "io/point_source.hpp"
#include "planescope/cloud.hpp"

/// \file One block of columns into a part of the cloud. Spans have one entry a point of the block.
namespace planescope::io {

/// x, y, z minus `origin`, subtracted in double. Returns how many of the points are finite.
std::size_t decode_positions(const std::vector<Column>& columns, const Selection& selection,
                             const Eigen::Vector3d& origin, std::span<Eigen::Vector3f> positions);

/// Packed colour, or channels: 16 bits are scaled to 8, reals from [0, 1] (beyond it: clamped; NaN:
/// 0). Needs one of the two.
void decode_colors(const std::vector<Column>& columns, const Selection& selection,
                   std::span<Rgb> colors);

/// Normals, made unit where they are not within 1e-3 of it, NaN where they have no length.
void decode_normals(const std::vector<Column>& columns, const Selection& selection,
                    std::span<Eigen::Vector3f> normals);

/// Numbers of any type; those that float does not hold or that are not finite become NaN, and where
/// they have to be `positive` zero and negative ones too.
void decode_numbers(const Column& column, bool positive, std::span<float> values);

/// Whole numbers into T; the index in the block of the first that T does not hold.
template <class T>
std::optional<std::size_t> decode_whole(const Column& column, std::span<T> values);

}  // namespace planescope::io
