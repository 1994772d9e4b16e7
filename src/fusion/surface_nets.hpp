// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fusion/voxel_field.hpp"

namespace planescope::fusion {

/// The surface points of one block's cells, one a cell at most.
struct BlockSurface {
  std::vector<Eigen::Vector3f> positions;  ///< [m] in the field's frame
  std::vector<Eigen::Vector3f> normals;    ///< unit, or NaN where the field is level
  std::vector<Rgb> colors;                 ///< of `positions`
  std::vector<std::uint16_t> cells;        ///< (z * 8 + y) * 8 + x of each, ascending
};

/// \param blocks must hold `block`; its neighbours towards +x, +y, +z are used where they are
/// there.
/// \param least frames that must have seen a voxel.
BlockSurface find_surface(const BlockMap& blocks, const Block& block, double voxel_size,
                          std::uint32_t least);

/// True if the field changes its sign between the voxel of `block` and the next one along an axis,
/// both being near the surface; +1 if it grows along the axis, -1 if it falls, 0 if it does not
/// cross.
int crossing(const BlockMap& blocks, const Block& block, int cell, int axis, std::uint32_t least);

}  // namespace planescope::fusion
