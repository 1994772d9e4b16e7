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

void OverlapSums::add(const Overlap& part) {
  Overlap& sum = sums_[{part.segment, part.object}];
  sum = {part.segment, part.object, sum.points + part.points, sum.steady + part.steady};
}

std::vector<Overlap> OverlapSums::list() const {
  std::vector<Overlap> all;
  for (const auto& [pair, sum] : sums_) all.push_back(sum);
  return all;
}

std::vector<std::uint32_t> ObjectBook::match(const std::vector<Segment>& segments,
                                             const std::vector<Overlap>& overlaps,
                                             TrackStep& step) {
  std::map<std::uint32_t, std::uint32_t> surviving;  // points of each object that are still there
  std::vector<std::uint32_t> carried(segments.size(), 0);
  for (const Overlap& o : overlaps) {
    surviving[o.object] += o.points;
    carried[o.segment] += o.points;
    step.carried += o.points;
    step.steady += o.steady;
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
  std::vector<std::uint32_t> parent(segments.size(), 0);  // that a new object was split from
  for (std::uint32_t s = 0; s < segments.size(); ++s) {
    if (object_of[s] != 0) continue;
    object_of[s] = ++last_;
    if (2 * carried[s] >= segments[s].point_count && carried[s] > 0) {
      parent[s] = heir_of(s);
    } else {
      add(TrackEventKind::New, object_of[s], 0, segments[s].point_count);
    }
  }
  for (const Overlap& o : ordered) {
    const std::uint32_t object = object_of[o.segment];
    if (object == o.object) {
      step.kept += o.points;
      step.steady_kept += o.steady;
    } else if (parent[o.segment] == o.object) {
      add(TrackEventKind::Split, o.object, object, o.points);
    } else if (!taken.contains(o.object) && 2 * o.points >= surviving[o.object]) {
      add(TrackEventKind::Merge, object, o.object, o.points);
    } else {
      add(TrackEventKind::Moved, o.object, object, o.points);
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

void ObjectBook::write(io::StateWriter& to) const {
  to.put(last_);
  to.list(std::vector<std::uint32_t>(alive_.begin(), alive_.end()));
  to.list(std::vector<std::uint32_t>(supported_.begin(), supported_.end()));
}

ObjectBook ObjectBook::read(io::StateReader& from) {
  ObjectBook book;
  book.last_ = from.get<std::uint32_t>();
  for (std::set<std::uint32_t>* set : {&book.alive_, &book.supported_}) {
    const std::vector<std::uint32_t> list = from.list<std::uint32_t>();
    set->insert(list.begin(), list.end());
    from.require(set->empty() || (*set->begin() >= 1 && *set->rbegin() <= book.last_),
                 "an object that was never numbered");
  }
  return book;
}

}  // namespace planescope::track
