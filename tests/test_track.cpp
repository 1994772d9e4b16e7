// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/track.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <set>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "track_fixtures.hpp"

namespace planescope {
namespace {

using namespace planescope::testing;  // NOLINT(google-build-using-namespace)

std::vector<TrackEvent> of_kind(const TrackStep& step, TrackEventKind kind) {
  std::vector<TrackEvent> events;
  std::ranges::copy_if(step.events, std::back_inserter(events),
                       [&](const TrackEvent& e) { return e.kind == kind; });
  return events;
}

TEST(Track, APlaneOverManyTilesIsOneObject) {
  MapTracker tracker;
  const TrackStep step = tracker.update(7, all(level(-1, 1, -1, 1, 0.3)));
  EXPECT_EQ(step.segments, 1u);
  EXPECT_EQ(step.planes, 1u);
  EXPECT_GE(step.tiles, 16u);
  EXPECT_EQ(tracker.objects(), std::vector<std::uint32_t>{1});
  ASSERT_EQ(of_kind(step, TrackEventKind::New).size(), 1u);
  EXPECT_EQ(of_kind(step, TrackEventKind::New)[0].frame, 7u);
  EXPECT_EQ(of_kind(step, TrackEventKind::New)[0].points, 40'000u);
  EXPECT_EQ(of_kind(step, TrackEventKind::Plane).size(), 1u);
  EXPECT_TRUE(tracker.scene().planes.at(0).plane.normal.isApprox(Eigen::Vector3f::UnitZ(), 1e-4f));
  EXPECT_NEAR(tracker.scene().planes.at(0).plane.distance, 0.3, 1e-4);
}

TEST(Track, NothingNewChangesNothing) {
  MapTracker tracker;
  const Pieces pieces = all(level(-1, 1, -1, 1, 0.3));
  tracker.update(0, pieces);
  const TrackStep again = tracker.update_exactly(1, pieces);
  EXPECT_EQ(again.changed, 0u);
  EXPECT_EQ(again.tiles, 0u);
  EXPECT_TRUE(again.events.empty());
  EXPECT_EQ(again.points, 40'000u);
}

TEST(Track, SmallChangesWaitUntilTheyMatter) {
  MapTracker tracker;
  tracker.update(0, all(level(-1, 1, -1, 1, 0.300)));
  EXPECT_EQ(tracker.update(1, all(level(-1, 1, -1, 1, 0.303))).changed, 0u);
  EXPECT_GT(tracker.update(2, all(level(-1, 1, -1, 1, 0.306))).changed, 0u);  // 5 mm is a quarter
  const TrackStep step = tracker.update_exactly(3, all(level(-1, 1, -1, 1, 0.307)));
  EXPECT_GT(step.changed, 0u);
  EXPECT_EQ(step.kept, step.carried);
  EXPECT_NEAR(tracker.scene().planes.at(0).plane.distance, 0.307, 1e-4);
}

TEST(Track, WhatIsAddedIsNewAndWhatWasKeepsItsNumber) {
  MapTracker tracker;
  tracker.update(0, all(level(-1, 1, -1, 1, 0)));
  const TrackStep step = tracker.update(1, all(level(-0.5, 0.5, -0.5, 0.5, 0.75)));
  EXPECT_EQ(step.segments, 2u);
  ASSERT_EQ(of_kind(step, TrackEventKind::New).size(), 1u);
  EXPECT_EQ(of_kind(step, TrackEventKind::New)[0].object, 2u);
  EXPECT_EQ(step.kept, step.carried);
  EXPECT_EQ(step.carried, 40'000u);
  EXPECT_EQ(tracker.objects(), (std::vector<std::uint32_t>{1, 2}));
  const TrackStep gone = tracker.update(2, emptied(all(level(-0.5, 0.5, -0.5, 0.5, 0.75))));
  ASSERT_EQ(gone.events.size(), 1u);
  EXPECT_EQ(gone.events[0].kind, TrackEventKind::Vanished);
  EXPECT_EQ(gone.events[0].object, 2u);
}

// Two table tops meet when the place between them is seen; and part when it is taken away.
TEST(Track, ObjectsMergeAndSplit) {
  MapTracker tracker;
  PointCloud small = level(-1.28, -0.32, -0.64, 0.64, 0.5);
  tracker.update(0, all(small));
  tracker.update(1, all(level(0, 1.92, -0.64, 0.64, 0.5)));
  EXPECT_EQ(tracker.objects(), (std::vector<std::uint32_t>{2, 1}));  // by size
  const Pieces between = all(level(-0.32, 0, -0.64, 0.64, 0.5));
  const TrackStep merged = tracker.update(2, between);
  ASSERT_EQ(merged.segments, 1u);
  ASSERT_EQ(of_kind(merged, TrackEventKind::Merge).size(), 1u);
  EXPECT_EQ(of_kind(merged, TrackEventKind::Merge)[0].object, 2u);
  EXPECT_EQ(of_kind(merged, TrackEventKind::Merge)[0].other, 1u);
  EXPECT_EQ(tracker.objects(), std::vector<std::uint32_t>{2});
  const TrackStep parted = tracker.update(3, emptied(between));
  ASSERT_EQ(parted.segments, 2u);
  ASSERT_EQ(of_kind(parted, TrackEventKind::Split).size(), 1u);
  EXPECT_EQ(of_kind(parted, TrackEventKind::Split)[0].object, 2u);
  EXPECT_EQ(of_kind(parted, TrackEventKind::Split)[0].other, 3u);  // 1 is never given again
  EXPECT_EQ(tracker.objects(), (std::vector<std::uint32_t>{2, 3}));
}

TEST(Track, EverythingGoes) {
  MapTracker tracker;
  const Pieces pieces = all(level(-1, 1, -1, 1, 0));
  tracker.update(0, pieces);
  const TrackStep step = tracker.update(1, emptied(pieces));
  EXPECT_EQ(step.points, 0u);
  EXPECT_EQ(step.segments, 0u);
  EXPECT_EQ(step.events.size(), 1u);
  EXPECT_EQ(tracker.update(2, pieces).segments, 1u);
  EXPECT_EQ(tracker.objects(), std::vector<std::uint32_t>{2});
}

TEST(Track, TheEndIsTheWholeAtOnce) {
  MapTracker tracker;
  scan(tracker, make_room(4));
  const TrackResult end = tracker.finish(4);
  const Segmentation batch = segment(tracker.map(), Options::room());
  EXPECT_EQ(end.scene.point_label, batch.point_label);
  EXPECT_EQ(end.scene.point_plane, batch.point_plane);
  ASSERT_EQ(end.objects.size(), batch.segments.segments.size());
  EXPECT_EQ(std::set(end.objects.begin(), end.objects.end()).size(), end.objects.size());
  // Most places are still what they were while it grew.
  EXPECT_GE(static_cast<double>(end.step.kept), 0.9 * static_cast<double>(end.step.carried));
}

// While it grows, patches end at the faces of tiles: planes are the same, small segments may not
// be.
TEST(Track, WhatGrowsAgreesWithTheWholeAtOnce) {
  MapTracker tracker;
  const PointCloud room = make_room(4);
  scan(tracker, room);
  ASSERT_EQ(tracker.map().size(), room.size());
  const Segmentation batch = segment(tracker.map(), Options::room());
  const Segmentation& grown = tracker.scene();
  EXPECT_GE(score_labels(grown.point_label, batch.point_label).weighted_overlap, 0.9);
  EXPECT_GE(score_labels(batch.point_label, grown.point_label).weighted_overlap, 0.9);
  EXPECT_GE(count_planes(grown.planes, PlaneRole::Support) + 1,
            count_planes(batch.planes, PlaneRole::Support));
  for (const SupportingPlane& plane : grown.planes) {
    if (plane.role == PlaneRole::Face) continue;  // small: patches decide
    const auto same = [&](const SupportingPlane& other) {
      return std::abs(plane.plane.normal.dot(other.plane.normal)) > 0.99985f &&  // 1 degree
             std::abs(std::abs(plane.plane.distance) - std::abs(other.plane.distance)) < 0.01f;
    };
    EXPECT_TRUE(std::ranges::any_of(batch.planes, same));
  }
}

TEST(Track, ThreadsDoNotMatter) {
  const PointCloud room = make_room(2);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    MapTracker tracker;
    scan(tracker, room);
    return tracker;
  };
  const MapTracker one = run(1), four = run(4);
  EXPECT_EQ(one.map().positions, four.map().positions);
  EXPECT_EQ(one.scene().point_label, four.scene().point_label);
  EXPECT_EQ(one.scene().graph.adjacency, four.scene().graph.adjacency);
  EXPECT_EQ(one.objects(), four.objects());
}

TEST(Track, ObjectsAreDistinct) {
  MapTracker tracker;
  scan(tracker, make_room(3));
  const auto& objects = tracker.objects();
  EXPECT_EQ(objects.size(), tracker.scene().segments.segments.size());
  EXPECT_EQ(std::set(objects.begin(), objects.end()).size(), objects.size());
}

// Each point that changed its object is in one event.
TEST(Track, EventsAccountForAllThatChanged) {
  MapTracker tracker;
  const PointCloud room = make_room(4, 150'000);
  std::size_t changed = 0;
  const auto check = [&](const TrackStep& step) {
    std::size_t in_events = 0;
    for (const TrackEvent& e : step.events) {
      const bool moves = e.kind == TrackEventKind::Split || e.kind == TrackEventKind::Merge ||
                         e.kind == TrackEventKind::Moved;
      if (moves) in_events += e.points;
    }
    EXPECT_EQ(in_events, step.carried - step.kept);
    changed += in_events;
  };
  for (std::uint32_t k = 0; k < 5; ++k) check(tracker.update(k, slab(room, k)));
  check(tracker.finish(5).step);
  EXPECT_GT(changed, 0u);
}

// Steady are the points of pieces that were given ten times.
TEST(Track, PointsSeenOftenAreCounted) {
  MapTracker tracker;
  const Pieces pieces = all(level(-1, 1, -1, 1, 0.3));
  for (std::uint32_t k = 0; k < 10; ++k) tracker.update(k, pieces);
  const Pieces more = all(level(-1, 1, 1.12, 1.92, 0.3));  // 8,000 points, in pieces of their own
  const TrackStep step = tracker.update(10, more);
  EXPECT_EQ(step.carried, 40'000u);
  EXPECT_EQ(step.steady, 40'000u);
  EXPECT_EQ(step.steady_kept, 40'000u);
  const TrackStep next = tracker.update_exactly(11, all(level(-1, 1, 1.12, 1.92, 0.301)));
  EXPECT_EQ(next.steady, 40'000u);
  EXPECT_EQ(next.carried, 56'000u);
}

// A share of a twentieth: about as many points are patched in each update, and all in the end.
TEST(Track, WorkIsSpreadOverUpdates) {
  TrackOptions options;
  options.interval = 4;
  options.share = 0.05;
  options.least_points = 1000;
  MapTracker tracker(options);
  const PointCloud room = make_room(4, 150'000);
  const Pieces pieces = all(room);
  std::size_t waiting = 1, tiles = 0, segmentations = 0;
  for (std::uint32_t k = 0; k < 120 && (k == 0 || waiting > 0 || k % 4 != 0); ++k) {
    const TrackStep step = tracker.update(k, k == 0 ? pieces : Pieces{});
    EXPECT_EQ(step.tiles > 0, k % 4 == 0 && (k == 0 || waiting > 0));
    EXPECT_EQ(step.segmented, k % 4 == 3);
    waiting = step.waiting;
    tiles = std::max(tiles, step.tiles);
    segmentations += step.segmented ? 1 : 0;
  }
  EXPECT_EQ(waiting, 0u);
  EXPECT_GT(segmentations, 3u);
  EXPECT_EQ(tracker.map().size(), room.size());
  MapTracker at_once;
  at_once.update(0, pieces);
  EXPECT_LT(tiles, at_once.update_exactly(1, emptied(pieces)).tiles / 4);
}

// A loop closure: all pieces are given anew, elsewhere. Nothing of the map stays behind.
TEST(Track, AMapThatMovesMovesWhole) {
  MapTracker tracker;
  const PointCloud before = level(-1, 1, -1, 1, 0.3);
  tracker.update(0, all(before));
  Pieces moved = all(before);
  for (SurfacePiece& piece : moved) {
    for (Eigen::Vector3f& p : piece.points.positions) p += Eigen::Vector3f(0.5f, 0, 0.2f);
  }
  const TrackStep step = tracker.update(1, moved);
  EXPECT_EQ(step.points, 40'000u);
  EXPECT_EQ(step.segments, 1u);
  ASSERT_EQ(tracker.map().size(), 40'000u);
  for (const Eigen::Vector3f& p : tracker.map().positions) {
    EXPECT_GT(p.x(), -0.51f);
    EXPECT_NEAR(p.z(), 0.5f, 1e-5f);
  }
}

// What is left out as too little while it grows is there at the end.
TEST(Track, TheEndTakesThePiecesAsTheyAre) {
  MapTracker tracker;
  tracker.update(0, all(level(-1, 1, -1, 1, 0.300)));
  const Pieces now = all(level(-1, 1, -1, 1, 0.302));
  EXPECT_EQ(tracker.update(1, now).changed, 0u);
  EXPECT_NEAR(tracker.finish(1).scene.planes.at(0).plane.distance, 0.300, 1e-4);
  const TrackResult end = tracker.finish(1, now);
  EXPECT_NEAR(end.scene.planes.at(0).plane.distance, 0.302, 1e-4);
  EXPECT_EQ(end.map.size(), 40'000u);
  EXPECT_EQ(end.step.kept, 40'000u);
  EXPECT_EQ(end.objects, std::vector<std::uint32_t>{1});
  EXPECT_EQ(tracker.finish(1, emptied(all(level(-1, 0, -1, 1, 0.3)))).map.size(), 20'000u);
}

TEST(Track, ColoursMayComeLater) {
  MapTracker tracker;
  tracker.update(0, all(level(-0.6, 0, -0.6, 0.6, 0.3)));
  Pieces colored = all(level(0, 0.6, -0.6, 0.6, 0.3));
  for (SurfacePiece& piece : colored) piece.points.colors.assign(piece.points.size(), {9, 8, 7});
  tracker.update(1, colored);
  EXPECT_EQ(tracker.map().colors.size(), tracker.map().size());
}

TEST(Track, WhatCannotBe) {
  TrackOptions options;
  options.tile_size = 0.1;
  EXPECT_THROW(MapTracker{options}, Error);
  options = {};
  options.change = 0;
  EXPECT_THROW(MapTracker{options}, Error);
  MapTracker tracker;
  Pieces pieces = all(level(0, 1, 0, 1, 0));
  pieces[1].points.normals.clear();
  EXPECT_THROW(tracker.update(0, pieces), Error);
  pieces = all(level(0, 1, 0, 1, 0));
  pieces[1].points.origin = Eigen::Vector3d(1, 0, 0);
  EXPECT_THROW(tracker.update(0, pieces), Error);
}

}  // namespace
}  // namespace planescope
