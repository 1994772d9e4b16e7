// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "color_matching.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "planescope/cloud.hpp"

namespace planescope::draw {
namespace {

using Labels = std::span<const std::uint32_t>;
constexpr std::uint32_t kUnmatched = 0xFFFFFFFF;

constexpr std::size_t kTellApart = 16;  // beyond, colours come twice

/// Indices of the largest values, at most `count`.
std::vector<std::uint32_t> largest(const std::vector<std::size_t>& values, std::size_t count) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return values[a] > values[b]; });
  order.resize(std::min(count, order.size()));
  return order;
}

/// Overlap of one object so far and one label.
struct Overlap {
  double share = 0;
  std::uint32_t object = 0, label = 0;
};

std::vector<std::size_t> count_labels(Labels labels) {
  std::vector<std::size_t> count(1, 0);
  for (const std::uint32_t label : labels) {
    if (label >= count.size()) count.resize(label + std::size_t{1}, 0);
    ++count[label];
  }
  return count;
}

/// All that overlap by at least `least`, the largest first.
std::vector<Overlap> overlaps(Labels objects, const std::vector<std::size_t>& object_points,
                              Labels labels, const std::vector<std::size_t>& label_points,
                              double least) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> both;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != kNoSegment && objects[i] != kUnmatched) ++both[{objects[i], labels[i]}];
  std::vector<Overlap> all;
  for (const auto& [pair, points] : both) {
    const std::size_t either = object_points[pair.first] + label_points[pair.second] - points;
    const double share = static_cast<double>(points) / static_cast<double>(either);
    if (share >= least) all.push_back({share, pair.first, pair.second});
  }
  std::sort(all.begin(), all.end(), [](const Overlap& a, const Overlap& b) {
    return std::tuple(-a.share, a.object, a.label) < std::tuple(-b.share, b.object, b.label);
  });
  return all;
}

/// The objects as one segmentation shows them: what it matched, per point.
std::vector<std::uint32_t> to_objects(Labels labels, const std::vector<std::uint32_t>& object) {
  std::vector<std::uint32_t> objects(labels.size(), kUnmatched);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != kNoSegment) objects[i] = object[labels[i]];
  return objects;
}

/// Each label's object among those that segmentation `from` shows, where both are still free.
void match_with(Labels labels, const std::vector<std::size_t>& label_points, Labels from,
                const std::vector<std::uint32_t>& from_object, double least,
                std::vector<std::uint32_t>& object, std::vector<char>& taken) {
  const auto shown = to_objects(from, from_object);
  std::vector<std::size_t> shown_points(taken.size(), 0);
  for (const std::uint32_t o : shown)
    if (o != kUnmatched) ++shown_points[o];
  for (const Overlap& overlap : overlaps(shown, shown_points, labels, label_points, least)) {
    if (object[overlap.label] != kUnmatched || taken[overlap.object] != 0) continue;
    object[overlap.label] = overlap.object;
    taken[overlap.object] = 1;
  }
}

}  // namespace

MatchedLabels match_labels(const std::vector<Labels>& labels, double least) {
  MatchedLabels matched;
  for (const Labels& own : labels) {
    const auto points = count_labels(own);
    std::vector<std::uint32_t> object(points.size(), kUnmatched);
    std::vector<char> taken(matched.points.size(), 0);
    for (std::size_t before = 0; before < matched.object.size(); ++before)
      match_with(own, points, labels[before], matched.object[before], least, object, taken);
    object[kNoSegment] = 0;
    for (std::uint32_t label = 1; label < points.size(); ++label) {
      if (points[label] == 0) object[label] = 0;  // nobody asks for it
      if (object[label] != kUnmatched) continue;
      object[label] = static_cast<std::uint32_t>(matched.points.size());
      matched.points.push_back(points[label]);
    }
    matched.object.push_back(std::move(object));
  }
  return matched;
}

std::vector<bool> objects_on_planes(const std::vector<Labels>& labels, const MatchedLabels& matched,
                                    std::span<const std::int32_t> point_plane) {
  std::vector<bool> flat(matched.points.size(), false), known(matched.points.size(), false);
  const bool planes = std::ranges::any_of(point_plane, [](auto p) { return p != kNone; });
  for (std::size_t s = 0; s < labels.size(); ++s) {
    std::vector<std::size_t> all(flat.size(), 0), on(flat.size(), 0);
    std::size_t total = 0;
    for (std::size_t i = 0; i < labels[s].size(); ++i) {
      if (labels[s][i] == kNoSegment) continue;
      const std::uint32_t object = matched.object[s][labels[s][i]];
      ++total;
      ++all[object];
      on[object] += point_plane[i] != kNone ? 1 : 0;
    }
    for (std::size_t object = 0; object < flat.size(); ++object) {
      if (known[object] || all[object] == 0) continue;
      known[object] = true;
      flat[object] = planes ? 2 * on[object] > all[object] : 10 * all[object] >= total;
    }
  }
  return flat;
}

std::vector<Pixel> color_objects(const MatchedLabels& matched, const std::vector<bool>& on_plane,
                                 const Neighbours& neighbours) {
  Neighbours apart = neighbours;
  const auto large = largest(matched.points, kTellApart);
  for (std::size_t i = 0; i < large.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      apart.emplace_back(std::min(large[i], large[j]), std::max(large[i], large[j]));
  std::vector<std::size_t> groups;
  groups.reserve(on_plane.size());
  for (const bool flat : on_plane) groups.push_back(flat ? 0 : 1);
  // Shading changes how light a large surface is from face to face: these differ in hue.
  std::vector<Pixel> calm;
  for (int hue = 75; hue < 435; hue += 40) calm.push_back(from_oklch(0.85, 0.085, hue));
  return assign_colors(groups, {calm, vivid_colors()}, apart);
}

Neighbours touching_objects(const std::vector<Labels>& labels, const MatchedLabels& matched,
                            std::span<const std::int32_t> point_patch, std::size_t patches,
                            const Neighbours& edges) {
  Neighbours touching;
  for (std::size_t s = 0; s < labels.size(); ++s) {
    std::vector<std::uint32_t> object(patches, kUnmatched);  // of a patch: that of its last point
    for (std::size_t i = 0; i < labels[s].size(); ++i) {
      if (point_patch[i] != kNone && labels[s][i] != kNoSegment)
        object[static_cast<std::size_t>(point_patch[i])] = matched.object[s][labels[s][i]];
    }
    for (const auto& [a, b] : edges) {
      if (object[a] != kUnmatched && object[b] != kUnmatched && object[a] != object[b])
        touching.emplace_back(std::min(object[a], object[b]), std::max(object[a], object[b]));
    }
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  return touching;
}

}  // namespace planescope::draw
