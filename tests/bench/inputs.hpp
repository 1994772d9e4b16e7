// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/options.hpp"
#include "planescope/sequence.hpp"

/// \file The clouds that benchmarks and score tables run on.
namespace planescope::bench {

/// The folder of shared data: `argument` if it is not empty, else PLANESCOPE_DATA, else the one
/// beside the source tree. It may not exist.
std::filesystem::path data_folder(const std::string& argument = {});

/// The table-top views in `folder`/mosd_learn, sorted by name; empty where they are absent.
std::vector<std::filesystem::path> tabletop_views(const std::filesystem::path& folder);

/// A synthesized furnished room, evenly sampled.
PointCloud room(std::uint64_t points, std::uint64_t random_seed = 1);

/// `columns` x `rows` copies of a cloud side by side along x and y, a metre apart: more points at
/// the same density.
PointCloud tiled(const PointCloud& cloud, int columns, int rows);

/// What `segment --depth` makes of an organised view: its depths in whole millimetres, unprojected.
PointCloud as_depth_view(const PointCloud& view, PinholeCamera lens);

/// Room options at the given radii [m].
Options room_options(double voxel_size, double patch_size);

}  // namespace planescope::bench
