// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <sstream>

#include "io/state_stream.hpp"
#include "planescope/error.hpp"
#include "planescope/fusion.hpp"
#include "planescope/track.hpp"
#include "sequence_fixtures.hpp"
#include "track/snapshot_parts.hpp"
#include "track_fixtures.hpp"

namespace planescope {
namespace {

using testing::Pieces;

template <class T>
std::string bytes_of(const T& value) {
  std::ostringstream to;
  value.write(to);
  return to.str();
}

template <class T>
T back(const std::string& bytes) {
  std::istringstream from(bytes);
  return T::read(from, "snapshot");
}

/// The message of the error that reading gives, or nothing.
template <class T>
std::string refusal(const std::string& bytes) {
  try {
    back<T>(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    return error.what();
  }
  return {};
}

TrackOptions spread(std::uint32_t interval = 3) {
  TrackOptions options;
  options.interval = interval;
  options.share = 0.2;
  options.least_points = 1000;
  return options;
}

/// The k-th of ten looks at a room: half a slab, and part of what was seen before moved a little.
Pieces look(const PointCloud& room, std::uint32_t k) {
  Pieces pieces = testing::slab(room, k / 2);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i % 2 == 0 || k % 2 == 0) continue;
    for (Eigen::Vector3f& p : pieces[i].points.positions) p.z() += 0.006f;
  }
  return pieces;
}

bool same(const TrackStep& a, const TrackStep& b) {
  const auto numbers = [](const TrackStep& s) {
    return std::vector<std::size_t>{s.frame,   s.pieces,      s.changed,      s.tiles,
                                    s.waiting, s.segmented,   s.points,       s.patches,
                                    s.planes,  s.segments,    s.carried,      s.kept,
                                    s.steady,  s.steady_kept, s.events.size()};
  };
  return numbers(a) == numbers(b);
}

class TrackSnapshotEvery : public ::testing::TestWithParam<std::uint32_t> {};

// Stopped after any update and read back, it goes on to the same bytes: between segmentations and,
// where several updates share one, within it.
TEST_P(TrackSnapshotEvery, GoingOnIsTheSameAsNotStopping) {
  const PointCloud room = testing::make_room(4, 100'000);
  constexpr std::uint32_t kLooks = 10;
  MapTracker whole(spread(GetParam()));
  std::vector<std::string> after = {bytes_of(whole)};
  std::vector<TrackStep> steps;
  for (std::uint32_t k = 0; k < kLooks; ++k) {
    steps.push_back(whole.update(k, look(room, k)));
    after.push_back(bytes_of(whole));
  }
  const TrackResult end = whole.finish(kLooks);
  for (std::uint32_t stop = 0; stop <= kLooks; ++stop) {
    MapTracker tracker = back<MapTracker>(after[stop]);
    EXPECT_EQ(bytes_of(tracker), after[stop]) << stop;
    for (std::uint32_t k = stop; k < kLooks; ++k) {
      EXPECT_TRUE(same(tracker.update(k, look(room, k)), steps[k])) << stop << " " << k;
    }
    EXPECT_EQ(bytes_of(tracker), after[kLooks]) << stop;
    const TrackResult other = tracker.finish(kLooks);
    EXPECT_EQ(other.scene.point_label, end.scene.point_label);
    EXPECT_EQ(other.objects, end.objects);
    EXPECT_TRUE(same(other.step, end.step));
  }
}

INSTANTIATE_TEST_SUITE_P(Intervals, TrackSnapshotEvery, ::testing::Values(1, 3, 6));

const DepthCamera kCamera{
    .lens = {.width = 80, .height = 60, .fx = 65, .fy = 65, .cx = 39.5, .cy = 29.5}};

/// A wall two metres away, every pixel of one colour.
void see_wall(TsdfVolume& volume, int k) {
  const DepthImage depth{80, 60, std::vector<std::uint16_t>(80 * 60, 2000)};
  const ColorImage color{80, 60, std::vector<Rgb>(80 * 60, Rgb{10, 200, 30})};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation().x() = 0.01 * k;
  volume.integrate(depth, k % 2 == 0 ? color : ColorImage{}, kCamera, pose);
}

TEST(TrackSnapshot, AVolumeGoesOnToTheSameBits) {
  TsdfVolume whole({.voxel_size = 0.03});
  std::string half;
  for (int k = 0; k < 6; ++k) {
    see_wall(whole, k);
    if (k == 2) half = bytes_of(whole);
  }
  TsdfVolume volume = back<TsdfVolume>(half);
  EXPECT_EQ(volume.frames(), 3u);
  for (int k = 3; k < 6; ++k) see_wall(volume, k);
  EXPECT_EQ(bytes_of(volume), bytes_of(whole));
  EXPECT_EQ(volume.points().positions, whole.points().positions);
  EXPECT_EQ(volume.points().colors, whole.points().colors);
  EXPECT_EQ(volume.changed_since(4), whole.changed_since(4));
}

/// Every bit that is flipped, and every byte that is missing, is noticed. All of short snapshots,
/// some of long ones.
template <class T>
void damage(const std::string& whole) {
  const std::size_t stride = std::max<std::size_t>(1, whole.size() / 400);
  for (std::size_t at = 0; at < whole.size(); at += at < 600 ? 7 : stride) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << at % 8));
    EXPECT_NE(refusal<T>(bytes), "") << "byte " << at;
    EXPECT_NE(refusal<T>(whole.substr(0, at)), "") << "length " << at;
  }
}

TEST(TrackSnapshot, DamageIsNoticed) {
  TsdfVolume volume({.voxel_size = 0.1});
  see_wall(volume, 0);
  damage<TsdfVolume>(bytes_of(volume));
  MapTracker tracker(spread());
  for (std::uint32_t k = 0; k < 4; ++k) {
    tracker.update(k, testing::all(testing::level(-0.5, 0.5 + k * 0.3, -0.5, 0.5, 0.3)));
  }
  damage<MapTracker>(bytes_of(tracker));
}

// A list as long as memory is refused before it is made.
TEST(TrackSnapshot, LengthsAreBoundedByTheFile) {
  std::ostringstream to;
  io::StateWriter writer(to, "lists", 1);
  writer.put<std::uint64_t>(std::uint64_t{1} << 60);
  writer.finish();
  std::istringstream from(to.str());
  io::StateReader reader(from, "snapshot", "lists", 1);
  EXPECT_THROW(reader.list<double>(), Error);
}

TEST(TrackSnapshot, OtherFilesAreRefusedInWords) {
  EXPECT_NE(refusal<MapTracker>("").find("cut short"), std::string::npos);
  EXPECT_NE(refusal<MapTracker>(std::string(100, 'x')).find("no snapshot"), std::string::npos);
  std::string later = bytes_of(MapTracker());
  later[8] = 3;
  EXPECT_NE(refusal<MapTracker>(later).find("version 3"), std::string::npos);
  std::string other_order = bytes_of(MapTracker());
  std::swap(other_order[12], other_order[15]);
  EXPECT_NE(refusal<MapTracker>(other_order).find("byte order"), std::string::npos);
  EXPECT_NE(refusal<MapTracker>(bytes_of(TsdfVolume())).find("expected `tracker`"),
            std::string::npos);
}

// By hand, for one word.
/// What a section of a tracker says that somebody made by hand, hash and all.
struct Forged {
  Eigen::Vector3f plane = Eigen::Vector3f::UnitZ();
  std::uint32_t last = 1, alive = 1, object = 1;
  std::int32_t key = 0;
  std::uint8_t flags = 2;  // patched
  std::uint64_t pieces = 1;
  float x = 0;
  int tiles = 1;
};

std::string forge(const Forged& what) {
  std::ostringstream stream;
  io::StateWriter to(stream, "tracker", 2);
  track::put_options(to, TrackOptions{});
  for (int k = 0; k < 4; ++k) to.put<std::uint64_t>(1);
  to.put<std::uint8_t>(0);
  for (int k = 0; k < 3; ++k) to.put(0.0);
  to.put(what.last);
  to.list(std::vector<std::uint32_t>{what.alive});
  to.list(std::vector<std::uint32_t>{});
  track::put_planes(to, {{.plane = {.normal = what.plane, .distance = 0}, .selected = true}});
  track::put_planes(to, {});
  to.put<std::uint64_t>(static_cast<std::uint64_t>(what.tiles));
  for (int tile = 0; tile < what.tiles; ++tile) {
    track::put_key(to, {what.key, 0, 0});
    to.put(what.pieces);
    for (std::uint64_t piece = 0; piece < what.pieces; ++piece) {
      track::put_key(to, {0, 0, 0});
      to.put<std::uint8_t>(1);
      PointCloud cloud = testing::level(0, 0.3, 0, 0.3, 0.01);
      cloud.positions.front().x() = what.x;
      track::put_cloud(to, cloud);
    }
    to.put<std::uint64_t>(0);
    to.put(what.flags);
    if ((what.flags & 2) != 0) to.list(std::vector<std::uint32_t>(1, what.object));
  }
  to.finish();
  return stream.str();
}

// Hashes tell damage, not intent: each guard behind them, by a section that breaks only its rule.
TEST(TrackSnapshot, ForgedSectionsAreRefused) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<Forged, std::string>> cases = {
      {{.plane = Eigen::Vector3f(1, 1, 0)}, "a plane without unit normal"},
      {{.plane = Eigen::Vector3f(kNan, 0, 1)}, "a plane without unit normal"},
      {{.last = 0, .alive = 1, .object = 1}, "an object that was never numbered"},
      {{.object = 0}, "a patch of no object"},
      {{.object = 2}, "a patch of no object"},
      {{.key = 1 << 30}, "a key out of range"},
      {{.flags = 9}, "a tile of no known state"},
      {{.flags = 0}, "a tile of no known state"},
      {{.pieces = 2}, "a piece twice"},
      {{.flags = 1, .tiles = 2}, "a tile twice"},
      {{.x = kNan}, "a point that is no place"},
      {{.x = 1e30F}, "a point that is no place"},
  };
  for (const auto& [forged, part] : cases) {
    const std::string said = refusal<MapTracker>(forge(forged));
    EXPECT_NE(said.find(part), std::string::npos) << part << ": " << said;
  }
}

TEST(TrackSnapshot, TheHashIsWhatTheFormatSays) {
  io::StateHash hash;
  EXPECT_EQ(hash.value(), 0xcbf29ce484222325ull);
  const std::uint64_t word = 42;
  hash.add(&word, sizeof word);
  std::uint64_t expected = (0xcbf29ce484222325ull ^ 42) * 0x100000001b3ull;
  expected ^= expected >> 32;
  EXPECT_EQ(hash.value(), expected);
}

}  // namespace
}  // namespace planescope
