// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "io/assemble.hpp"
#include "io/input_file.hpp"
#include "planescope/io.hpp"

/// \file Reading PCD files: ascii, binary, binary_compressed.
namespace planescope::io {

/// Reads a PCD file; `extra` names integer columns (8 to 64 bits, signed or not) that are returned
/// beside the cloud as 32-bit numbers, in the order asked for. `origin`: the shift to apply, or
/// nothing for the one that choose_origin() finds.
/// \throws Error{Kind::Input} malformed, truncated, beyond the limits; no finite point; an extra
/// column is missing, or holds a number beyond 32 bits.
Assembled read_pcd(const InputFile& file, const ReadLimits& limits,
                   const std::vector<std::string>& extra = {},
                   const std::optional<Eigen::Vector3d>& origin = {});

/// The same by file name: for the result folder, whose `points.pcd` has the columns `plane` and
/// `patch` (`label` is in cloud.labels). Give the origin the result was computed with: planes are
/// relative to it, and an origin that is found anew may differ by a metre.
/// \code
/// const auto [cloud, columns] = io::read_pcd_columns(folder / "points.pcd", {"plane", "patch"});
/// \endcode
Assembled read_pcd_columns(const std::filesystem::path& file, const std::vector<std::string>& extra,
                           const std::optional<Eigen::Vector3d>& origin = {},
                           const ReadLimits& limits = {});

}  // namespace planescope::io
