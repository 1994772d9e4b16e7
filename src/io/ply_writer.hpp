// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/io.hpp"

/// \file Writing PLY files.
namespace planescope::io {

/// Writes one element `vertex`: x y z [red green blue] [nx ny nz] [label]; binary is little-endian.
/// PLY has no place for width, height and sensor: those are not kept.
/// \throws Error{Kind::Usage} no points, or parts that differ in length.
/// \throws Error{Kind::Input} the folder is missing or read-only; the disk is full.
void write_ply(const std::filesystem::path& file, const PointCloud& cloud, CloudEncoding encoding);

/// The same with an element `face` of triangles, binary. \throws Error as above.
void write_ply(const std::filesystem::path& file, const PointCloud& vertices,
               const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace planescope::io
