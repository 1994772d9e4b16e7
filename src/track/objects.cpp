// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track/objects.hpp"

#include <algorithm>
#include <tuple>

namespace planescope::track {
namespace {

constexpr double kShare = 0.2;  // of the smaller side, for a match or an event

std::vector<Overlap> largest_first(std::vector<Overlap> overlaps) {
  std::ranges::sort(overlaps, [](const Overlap& a, const Overlap& b) {
    return std::tuple(b.points, a.segment, a.object) < std::tuple(a.points, b.segment, b.object);
  });
  return overlaps;
}

}  // namespace

std::vector<std::uint32_t> ObjectBook::match(const std::vector<Segment>& segments,
                                             const std::vector<Overlap>& overlaps,
                                             TrackStep& step) {
  std::map<std::uint32_t, std::uint32_t> surviving;  // points of each object that are still there
  std::vector<std::uint32_t> carried(segments.size(), 0);
  for (const Overlap& o : overlaps) {
    surviving[o.object] += o.points;
    carried[o.segment] += o.points;
    step.carried += o.points;
  }
  const auto counts = [&](const Overlap& o) {
    return o.points >= kShare * surviving[o.object] || o.points >= kShare * carried[o.segment];
  };
  const auto add = [&](TrackEventKind kind, std::uint32_t object, std::uint32_t other,
                       std::uint32_t points) {
    step.events.push_back({step.frame, kind, object, other, points});
  };
  std::vector<std::uint32_t> object_of(segments.size(), 0);
  std::set<std::uint32_t> taken;
  const std::vector<Overlap> ordered = largest_first(overlaps);
  for (const Overlap& o : ordered) {
    if (object_of[o.segment] != 0 || taken.contains(o.object) || !counts(o)) continue;
    object_of[o.segment] = o.object;
    taken.insert(o.object);
  }
  const auto heir_of = [&](std::uint32_t segment) {  // the object most of it was before
    const auto found = std::ranges::find(ordered, segment, &Overlap::segment);
    return found == ordered.end() ? 0u : found->object;
  };
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (object_of[s] != 0) continue;
    object_of[s] = ++last_;
    const std::uint32_t parent = heir_of(s);
    const bool split = 2 * carried[s] >= segments[s].point_count;
    add(split ? TrackEventKind::Split : TrackEventKind::New, split ? parent : object_of[s],
        split ? object_of[s] : 0, segments[s].point_count);
  }
  for (const Overlap& o : ordered) {
    if (object_of[o.segment] == o.object) {
      step.kept += o.points;
    } else if (!taken.contains(o.object) && 2 * o.points >= surviving[o.object]) {
      add(TrackEventKind::Merge, object_of[o.segment], o.object, o.points);
    }
  }
  for (const std::uint32_t object : alive_) {
    if (!surviving.contains(object)) add(TrackEventKind::Vanished, object, 0, 0);
  }
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (segments[s].plane == kNone || !supported_.insert(object_of[s]).second) continue;
    add(TrackEventKind::Plane, object_of[s], 0, segments[s].point_count);
  }
  alive_ = std::set<std::uint32_t>(object_of.begin(), object_of.end());
  return object_of;
}

}  // namespace planescope::track
