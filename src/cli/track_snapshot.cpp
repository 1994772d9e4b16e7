// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/track_snapshot.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

#include "io/state_stream.hpp"
#include "planescope/error.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kVersion = 2;
constexpr const char* kName = "track";

std::array<double, 9> camera_numbers(const DepthCamera& camera) {
  const PinholeCamera& lens = camera.lens;
  return {double(lens.width), double(lens.height), lens.fx,         lens.fy, lens.cx, lens.cy,
          camera.depth_scale, camera.min_depth,    camera.max_depth};
}

void put_pose(io::StateWriter& to, const Eigen::Isometry3d& pose) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) to.put(pose.matrix()(row, column));
  }
}

Eigen::Isometry3d get_pose(io::StateReader& from) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) pose.matrix()(row, column) = from.get<double>();
  }
  return pose;
}

/// The poses of frames already fused must be what they were.
void check_pose(const FrameInfo& now, const Eigen::Isometry3d& before, const std::string& file) {
  if (now.pose.matrix() == before.matrix()) return;
  const double moved = (now.pose.translation() - before.translation()).norm();
  const Eigen::AngleAxisd turn(before.linear().transpose() * now.pose.linear());
  char text[256];
  std::snprintf(text, sizeof text,
                ": the pose of frame %u has moved by %.3g m and %.3g degrees since (a loop was "
                "closed?), and what is fused cannot be moved; track the sequence from its first "
                "frame, without --resume",
                now.number, moved, turn.angle() * 180 / std::numbers::pi);
  throw Error(Error::Kind::Input, file + text);
}

/// \returns how many frames are done.
std::size_t check_sequence(io::StateReader& from, const Sequence& sequence,
                           const std::string& file) {
  for (const double value : camera_numbers(sequence.camera())) {
    if (from.get<double>() == value) continue;
    throw Error(Error::Kind::Usage,
                file +
                    ": was made with another camera, depth scale or range of depths; give the "
                    "same --intrinsics, --depth-scale, --min-depth and --max-depth");
  }
  const bool with_color = from.get<std::uint8_t>() != 0;
  if (with_color != sequence.with_color()) {
    throw Error(Error::Kind::Usage, file + ": was made with" + (with_color ? "out" : "") +
                                        " --no-color; give the options of that run");
  }
  const std::size_t done = from.length(4 + 12 * sizeof(double));
  for (std::size_t i = 0; i < done; ++i) {
    const auto number = from.get<std::uint32_t>();
    const Eigen::Isometry3d pose = get_pose(from);
    if (i >= sequence.size() || sequence.info(i).number != number) {
      throw Error(Error::Kind::Input,
                  file + ": frame " + std::to_string(number) +
                      " was tracked, and is not in its place in the sequence now; give the same "
                      "SEQUENCE and --frames, which may only go on further");
    }
    check_pose(sequence.info(i), pose, file);
  }
  return done;
}

void refuse(const std::string& file, const std::string& option, const std::string& was,
            const std::string& is) {
  if (was == is) return;
  throw Error(Error::Kind::Usage, file + ": was made with " + option + " " + was + ", not " + is +
                                      "; give the options of that run");
}

void check_options(const std::string& file, const TrackOptions& was, const TrackOptions& is) {
  for (const OptionInfo& info : option_table()) {
    refuse(file, "--" + info.name, get_option(was.engine, info.name),
           get_option(is.engine, info.name));
  }
  refuse(file, "--tile", std::to_string(was.tile_size), std::to_string(is.tile_size));
  refuse(file, "--step", std::to_string(was.interval), std::to_string(is.interval));
}

void check_fusion(const std::string& file, const FusionOptions& was, const FusionOptions& is) {
  const double truncation = is.truncation > 0 ? is.truncation : 4 * is.voxel_size;
  refuse(file, "--fusion-voxel", std::to_string(was.voxel_size), std::to_string(is.voxel_size));
  refuse(file, "--truncation", std::to_string(was.truncation), std::to_string(truncation));
  refuse(file, "--min-observations", std::to_string(was.min_observations),
         std::to_string(is.min_observations));
}

}  // namespace

void write_snapshot(const TrackRun& run, const Sequence& sequence, const fs::path& folder) {
  std::ofstream stream(folder / kSnapshotFile, std::ios::binary);
  io::StateWriter to(stream, kName, kVersion);
  for (const double value : camera_numbers(sequence.camera())) to.put(value);
  to.put<std::uint8_t>(sequence.with_color() ? 1 : 0);
  to.put<std::uint64_t>(run.done);
  for (std::size_t i = 0; i < run.done; ++i) {
    to.put(sequence.info(i).number);
    put_pose(to, sequence.info(i).pose);
  }
  run.tables.store(to);
  to.put<std::uint64_t>(run.pictures.size());
  for (const std::string& picture : run.pictures) to.text(picture);
  to.finish();
  run.volume.write(stream);
  run.tracker.write(stream);
  stream.close();
  if (!stream) {
    throw Error(Error::Kind::Input,
                (folder / kSnapshotFile).string() + ": cannot be written (is the disk full?)");
  }
}

TrackRun read_snapshot(const fs::path& folder, const Sequence& sequence,
                       const TrackOptions& options, const FusionOptions& fusion) {
  const std::string file = (folder / kSnapshotFile).string();
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw Error(Error::Kind::Input,
                file + ": cannot be opened; --resume takes a folder that track --every wrote");
  }
  TrackTables tables;
  io::StateReader from(stream, file, kName, kVersion);
  const std::size_t done = check_sequence(from, sequence, file);
  tables.restore(from);
  std::vector<std::string> pictures;
  for (std::size_t left = from.length(8); left > 0; --left) pictures.push_back(from.text());
  from.finish();
  TsdfVolume volume = TsdfVolume::read(stream, file);
  check_fusion(file, volume.options(), fusion);
  MapTracker tracker = MapTracker::read(stream, file);
  check_options(file, tracker.options(), options);
  return {std::move(volume), std::move(tracker), std::move(tables), done, std::move(pictures)};
}

}  // namespace planescope::cli
