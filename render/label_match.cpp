// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "label_match.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "palette.hpp"

namespace planescope::draw {
namespace {

std::unordered_map<std::uint32_t, double> sizes(std::span<const std::uint32_t> labels) {
  std::unordered_map<std::uint32_t, double> counts;
  for (const std::uint32_t label : labels) counts[label] += 1;
  return counts;
}

/// All pairs that share points.
std::vector<LabelPair> overlaps(std::span<const std::uint32_t> first,
                                std::span<const std::uint32_t> second) {
  std::unordered_map<std::uint64_t, double> shared;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != 0 && second[i] != 0) shared[(std::uint64_t{first[i]} << 32) | second[i]] += 1;
  }
  const auto a = sizes(first), b = sizes(second);
  std::vector<LabelPair> pairs;
  for (const auto& [key, count] : shared) {
    const auto x = static_cast<std::uint32_t>(key >> 32), y = static_cast<std::uint32_t>(key);
    pairs.push_back({x, y, count / (a.at(x) + b.at(y) - count)});
  }
  return pairs;
}

}  // namespace

std::vector<LabelPair> match_labels(std::span<const std::uint32_t> first,
                                    std::span<const std::uint32_t> second) {
  std::vector<LabelPair> pairs = overlaps(first, second);
  std::sort(pairs.begin(), pairs.end(), [](const LabelPair& p, const LabelPair& q) {
    return std::tuple(-p.overlap, p.first, p.second) < std::tuple(-q.overlap, q.first, q.second);
  });
  std::set<std::uint32_t> taken_first, taken_second;
  std::erase_if(pairs, [&](const LabelPair& pair) {
    if (taken_first.contains(pair.first) || taken_second.contains(pair.second)) return true;
    taken_first.insert(pair.first);
    taken_second.insert(pair.second);
    return false;
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const LabelPair& p, const LabelPair& q) { return p.first < q.first; });
  return pairs;
}

std::vector<Pixel> matched_colors(std::span<const std::uint32_t> reference,
                                  const std::vector<Pixel>& reference_colors,
                                  std::span<const std::uint32_t> labels) {
  std::uint32_t most = 0;
  for (const std::uint32_t label : labels) most = std::max(most, label);
  std::vector<Pixel> free = vivid_colors();
  std::map<Pixel, int> uses;
  for (const Pixel& color : reference_colors) ++uses[color];
  std::stable_sort(free.begin(), free.end(),
                   [&](const Pixel& a, const Pixel& b) { return uses[a] < uses[b]; });
  std::vector<Pixel> colors(most);
  std::vector<bool> matched(most, false);
  for (const LabelPair& pair : match_labels(reference, labels)) {
    if (pair.first > reference_colors.size()) continue;
    colors[pair.second - 1] = reference_colors[pair.first - 1];
    matched[pair.second - 1] = true;
  }
  std::size_t next = 0;
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (!matched[i]) colors[i] = free[next++ % free.size()];
  return colors;
}

}  // namespace planescope::draw
