// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// \file Where the number of a segment is put, so that it lies on that segment.
namespace planescope::draw {

/// What is seen where, coarsely: labels of cells, rows from the top; 0: nothing, or no segment.
struct LabelMap {
  int width = 0, height = 0;  ///< [cell]
  std::vector<std::uint32_t> labels;

  std::uint32_t at(int x, int y) const {
    return labels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// [cell] How far it is from each cell to the nearest one of another label, or to the rim, diagonal
/// steps as long as straight ones: 1 along borders.
std::vector<int> clearance(const LabelMap& map);

/// The cell of each label from 1 to `count` where a number of half the width `needed` [cell] is
/// read best: of those with that much room, or the most that there is, the one that is nearest to
/// the preferred one, that of its centroid. Nothing where no cell has half a number's height of
/// room, `least`.
std::vector<std::optional<std::array<int, 2>>> label_places(
    const LabelMap& map, std::uint32_t count,
    const std::function<std::array<int, 2>(std::uint32_t)>& preferred,
    const std::function<int(std::uint32_t)>& needed, int least);

}  // namespace planescope::draw
