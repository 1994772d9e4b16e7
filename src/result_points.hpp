// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "planescope/result.hpp"

/// \file points.pcd of the result folder: binary PCD with the fields `x y z rgb label plane patch`.
/// x y z are world coordinates, float, or double where the cloud's origin is not zero; rgb is PCL's
/// packed float; label U4; plane and patch I4 (-1: none).
namespace planescope {

/// The file's bytes. `result.cloud` and the three columns have one entry a point.
std::string points_pcd(const Result& result);

/// Reads what points_pcd() wrote into `result`: cloud.positions, cloud.colors and the three
/// columns. `result.cloud.origin`, `width`, `height` and `has_colors` are set by the caller (they
/// are in result.json), and the file must agree with them.
/// \throws Error{Kind::Input} the header is another, or the bytes are not as many as it says.
void parse_points_pcd(const std::string& bytes, const std::filesystem::path& file, Result& result);

}  // namespace planescope
