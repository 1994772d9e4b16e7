// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "planescope/result.hpp"

/// \file points.pcd of the result folder: binary PCD with the fields `x y z rgb label plane patch`.
/// x y z are world coordinates, float, or double where the cloud's origin is not zero; rgb is PCL's
/// packed float; label U4; plane and patch I4 (-1: none).
namespace planescope {

/// What goes into the file: one entry a point in each column.
struct ResultPoints {
  const PointCloud& cloud;
  std::span<const std::uint32_t> label;
  std::span<const std::int32_t> plane, patch;
};

/// The file's bytes.
std::string points_pcd(const ResultPoints& points);

/// Reads what points_pcd() wrote into `result`: cloud.positions, cloud.colors and the three
/// columns. `result.cloud.origin`, `width`, `height` and `has_colors` are set by the caller (they
/// are in result.json), and the file must agree with them.
/// \throws Error{Kind::Input} the header is another, or the bytes are not as many as it says.
void parse_points_pcd(std::string_view bytes, const std::filesystem::path& file, Result& result);

}  // namespace planescope
