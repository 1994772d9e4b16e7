// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "track/tracker_state.hpp"

namespace planescope {

using track::PatchedTile;
using track::Tile;

namespace {

/// Patches a tile anew; what its places were votes for what they become.
void renew(Tile& tile, const BlockKey& key, const TrackOptions& options, double place_size) {
  if (!tile.fresh) {  // else nobody knows objects of the patches, but the memory does of places
    tile.memory = tile.patched ? track::remember(*tile.patched, tile.objects, place_size)
                               : track::PlaceMemory();
  }
  tile.patched = std::make_shared<const PatchedTile>(track::patch_tile(
      track::gather(tile.pieces), key, options.tile_size, options.engine.patches));
  tile.votes = track::vote(tile, place_size, options.steady_after);
  tile.steady.clear();
  tile.objects.clear();
  tile.fresh = true;
  tile.dirty = false;
  tile.changed = 0;
}

}  // namespace

/// The tiles to patch now: those of which the largest part has changed, as many as the options
/// allow; of equals the lower key.
std::vector<BlockKey> MapTracker::State::most_changed() const {
  std::vector<std::pair<double, BlockKey>> order;
  for (const auto& [key, tile] : tiles) {
    if (!tile.dirty) continue;
    const auto points = static_cast<double>(std::max<std::size_t>(1, tile.points));
    order.emplace_back(-static_cast<double>(tile.changed) / points, key);
  }
  std::ranges::sort(order);
  const bool all = options.share >= 1;
  const double most =
      std::max<double>(options.least_points, options.share * static_cast<double>(point_count));
  double spent = 0;
  std::vector<BlockKey> keys;
  for (const auto& [part, key] : order) {
    if (!all && spent >= most) break;
    spent += static_cast<double>(tiles.at(key).points);
    keys.push_back(key);
  }
  return keys;
}

/// \returns the number of tiles that were patched.
std::size_t MapTracker::State::repatch() {
  const std::vector<BlockKey> keys = most_changed();
  std::vector<Tile*> chosen;
  chosen.reserve(keys.size());
  for (const BlockKey& key : keys) chosen.push_back(&tiles.at(key));
  tbb::parallel_for(std::size_t{0}, keys.size(),
                    [&](std::size_t i) { renew(*chosen[i], keys[i], options, place_size()); });
  join(keys);
  return keys.size();
}

/// Finds anew which patches of these tiles touch those of their neighbours.
void MapTracker::State::join(const std::vector<BlockKey>& keys) {
  std::set<std::pair<BlockKey, BlockKey>> wanted;
  for (const BlockKey& key : keys) {
    for (int n = 0; n < 27; ++n) {
      const BlockKey near{key.x + n % 3 - 1, key.y + n / 3 % 3 - 1, key.z + n / 9 - 1};
      const auto found = tiles.find(near);
      if (near != key && found != tiles.end() && found->second.patched) {
        wanted.emplace(std::min(key, near), std::max(key, near));
      }
    }
  }
  const std::vector<std::pair<BlockKey, BlockKey>> pairs(wanted.begin(), wanted.end());
  std::vector<std::vector<Adjacency>> found(pairs.size());
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    found[i] =
        track::join_tiles(*tiles.at(pairs[i].first).patched, *tiles.at(pairs[i].second).patched);
  });
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (found[i].empty()) {
      joints.erase(pairs[i]);
    } else {
      joints[pairs[i]] = std::move(found[i]);
    }
  }
}

}  // namespace planescope
