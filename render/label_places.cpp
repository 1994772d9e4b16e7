// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "label_places.hpp"

#include <algorithm>
#include <tuple>

namespace planescope::draw {
namespace {

std::size_t index(const LabelMap& map, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(x);
}

bool inside(const LabelMap& map, int x, int y) {
  return x >= 0 && y >= 0 && x < map.width && y < map.height;
}

/// One more than the least clearance of four neighbours; beyond the rim and on other labels it
/// is 0.
void relax(const LabelMap& map, std::vector<int>& room, int x, int y,
           const std::array<std::array<int, 2>, 4>& steps) {
  int& here = room[index(map, x, y)];
  for (const auto& [dx, dy] : steps) {
    const bool same = inside(map, x + dx, y + dy) && map.at(x + dx, y + dy) == map.at(x, y);
    here = std::min(here, 1 + (same ? room[index(map, x + dx, y + dy)] : 0));
  }
}

}  // namespace

std::vector<int> clearance(const LabelMap& map) {
  std::vector<int> room(map.labels.size(), map.width + map.height);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      relax(map, room, x, y, {{{-1, 0}, {-1, -1}, {0, -1}, {1, -1}}});
  for (int y = map.height - 1; y >= 0; --y)
    for (int x = map.width - 1; x >= 0; --x)
      relax(map, room, x, y, {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}});
  return room;
}

std::vector<std::optional<std::array<int, 2>>> label_places(
    const LabelMap& map, std::uint32_t count,
    const std::function<std::array<int, 2>(std::uint32_t)>& preferred,
    const std::function<int(std::uint32_t)>& needed, int least) {
  const std::vector<int> room = clearance(map);
  using Rank = std::tuple<int, int>;  // room, and the negative squared distance
  std::vector<std::optional<std::array<int, 2>>> places(count);
  std::vector<Rank> best(count);
  std::vector<std::array<int, 2>> wished;
  for (std::uint32_t label = 1; label <= count; ++label) wished.push_back(preferred(label));
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::uint32_t label = map.at(x, y);
      const int here = room[index(map, x, y)];
      if (label == 0 || label > count || here < least) continue;
      const int dx = x - wished[label - 1][0], dy = y - wished[label - 1][1];
      const Rank rank{std::min(here, needed(label)), -(dx * dx + dy * dy)};
      if (places[label - 1] && rank <= best[label - 1]) continue;
      places[label - 1] = {x, y};
      best[label - 1] = rank;
    }
  }
  return places;
}

}  // namespace planescope::draw
