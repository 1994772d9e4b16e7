// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "fuzz_target.hpp"
#include "planescope/image.hpp"
#include "planescope/sequence.hpp"

/// \file The lists, poses and cameras of sequences: the first byte says which file the others are;
/// the rest of the sequence is sound.
namespace planescope::fuzzing {
namespace {

constexpr std::string_view kPose = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

/// A sequence of one frame in each layout.
struct Folders {
  ScratchFolder tum, redwood, frames;

  Folders() {
    const DepthImage depth{4, 3, std::vector<std::uint16_t>(12, 1000)};
    std::filesystem::create_directory(redwood.path() / "depth");
    write_depth_image(depth, tum.path() / "1.png");
    write_depth_image(depth, redwood.path() / "depth" / "000000.png");
    write_depth_image(depth, frames.path() / "frame-000000.depth.png");
    repair();
  }
  void repair() const {
    tum.write("depth.txt", "1.0 1.png\n");
    tum.write("groundtruth.txt", "1.0 0 0 0 0 0 0 1\n");
    redwood.write("trajectory.log", "0 0 1\n" + std::string(kPose));
    frames.write("frame-000000.pose.txt", kPose);
    for (const ScratchFolder* folder : {&tum, &redwood, &frames}) {
      for (const char* camera : {"camera.txt", "camera_intrinsic.json", "info.txt"})
        std::filesystem::remove(folder->path() / camera);
    }
  }
};

void open(const ScratchFolder& folder) {
  const Sequence sequence(folder.path());
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    if (!sequence.info(i).pose.matrix().allFinite()) std::abort();
    sequence.read(i);
  }
  sequence.up();
}

void read_as(char kind, const Folders& folders, std::string_view bytes) {
  switch (kind) {
    case 'd':
      folders.tum.write("depth.txt", bytes);
      return open(folders.tum);
    case 'g':
      folders.tum.write("groundtruth.txt", bytes);
      return open(folders.tum);
    case 'l':
      folders.redwood.write("trajectory.log", bytes);
      return open(folders.redwood);
    case 'p':
      folders.frames.write("frame-000000.pose.txt", bytes);
      return open(folders.frames);
    case 'j':
      folders.redwood.write("camera_intrinsic.json", bytes);
      return open(folders.redwood);
    case 'i':
      folders.frames.write("info.txt", bytes);
      return open(folders.frames);
    default:
      folders.tum.write("camera.txt", bytes);
      open(folders.tum);
  }
}

}  // namespace

void fuzz(std::string_view bytes) {
  static const Folders folders;
  if (bytes.empty()) return;
  refused_or_taken([&] { read_as(bytes.front(), folders, bytes.substr(1)); });
  folders.repair();
}

}  // namespace planescope::fuzzing
