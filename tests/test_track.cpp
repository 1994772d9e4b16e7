// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/track.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/synthesize.hpp"
#include "synthesis_fixtures.hpp"

namespace planescope {
namespace {

constexpr double kPiece = 0.16;  // [m]

using Pieces = std::vector<SurfacePiece>;

/// The cloud's points by cells of a grid, those that `take` takes.
Pieces cut(const PointCloud& cloud, const std::function<bool(const Eigen::Vector3f&)>& take) {
  std::map<BlockKey, PointCloud> cells;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f& p = cloud.positions[i];
    const auto part = [](float v) { return static_cast<std::int32_t>(std::floor(v / kPiece)); };
    if (!take(p)) continue;
    PointCloud& cell = cells[{part(p.x()), part(p.y()), part(p.z())}];
    cell.positions.push_back(p);
    cell.normals.push_back(cloud.normals[i]);
  }
  Pieces pieces;
  for (auto& [key, points] : cells) pieces.push_back({key, std::move(points)});
  return pieces;
}

Pieces all(const PointCloud& cloud) {
  return cut(cloud, [](const Eigen::Vector3f&) { return true; });
}

/// The same places, empty.
Pieces emptied(Pieces pieces) {
  for (SurfacePiece& piece : pieces) piece.points = {};
  return pieces;
}

/// A rectangle at height z, facing up, a point a square centimetre.
PointCloud level(double x0, double x1, double y0, double y1, double z) {
  PointCloud cloud;
  for (double x = x0 + 0.005; x < x1; x += 0.01) {
    for (double y = y0 + 0.005; y < y1; y += 0.01) {
      cloud.positions.push_back(Eigen::Vector3d(x, y, z).cast<float>());
      cloud.normals.push_back(Eigen::Vector3f::UnitZ());
    }
  }
  return cloud;
}

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

PointCloud make_room(std::uint64_t seed) {
  SynthesisOptions options = testing::evenly(seed, 300'000);
  options.normals = true;
  return synthesize(options).cloud;
}

/// A room that is seen in five slabs, one after the other.
void scan(MapTracker& tracker, const PointCloud& room) {
  for (std::uint32_t k = 0; k < 5; ++k) {
    const double from = -5 + 2.0 * k, to = from + 2;
    tracker.update(k, cut(room, [&](const Eigen::Vector3f& p) {
                     const double x = std::floor(double(p.x()) / kPiece) * kPiece;
                     return x >= from && x < to;
                   }));
  }
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
  EXPECT_GE(grown.planes.size() + 1, batch.planes.size());
  for (const SupportingPlane& plane : grown.planes) {
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
