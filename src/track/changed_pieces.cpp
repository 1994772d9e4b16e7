// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>

#include "planescope/track.hpp"

namespace planescope {

std::vector<SurfacePiece> changed_pieces(const TsdfVolume& volume, std::uint32_t since) {
  std::vector<BlockKey> keys;
  for (const BlockKey& key : volume.changed_since(since)) {
    for (int n = 0; n < 8; ++n) {
      keys.push_back({key.x - (n & 1), key.y - (n >> 1 & 1), key.z - (n >> 2)});
    }
  }
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<SurfacePiece> pieces(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t i) {
    pieces[i] = {keys[i], volume.block_points(keys[i])};
  });
  return pieces;
}

}  // namespace planescope
