// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>
#include <vector>

#include "fuzz_target.hpp"
#include "planescope/image.hpp"
#include "planescope/sequence.hpp"

/// \file The lists, poses and cameras of sequences: the first byte says which file the others are;
/// the rest of the sequence is sound.
namespace planescope::fuzzing {
namespace {

constexpr const char* kPose = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

/// A file of a sequence, and what it holds where it is sound.
struct SequenceFile {
  char kind;
  std::size_t folder;
  const char* name;
  std::string sound;
};

/// A sequence of one frame in each layout.
class Sequences {
 public:
  Sequences() {
    const DepthImage depth{4, 3, std::vector<std::uint16_t>(12, 1000)};
    std::filesystem::create_directory(folders_[1].path() / "depth");
    write_depth_image(depth, folders_[0].path() / "1.png");
    write_depth_image(depth, folders_[1].path() / "depth" / "000000.png");
    write_depth_image(depth, folders_[2].path() / "frame-000000.depth.png");
    for (const SequenceFile& file : files_) repair(file);
    for (const ScratchFolder& folder : folders_) open(folder);  // throws: they are not sound
  }

  /// Opens a sequence of which one file holds these bytes.
  void open_with(char kind, std::string_view bytes) {
    for (const SequenceFile& file : files_) {
      if (file.kind != kind) continue;
      folders_[file.folder].write(file.name, bytes);
      refused_or_taken([&] { open(folders_[file.folder]); });
      repair(file);
    }
  }

 private:
  static void open(const ScratchFolder& folder) {
    const Sequence sequence(folder.path());
    for (std::size_t i = 0; i < sequence.size(); ++i) {
      if (!sequence.info(i).pose.matrix().allFinite()) std::abort();
      sequence.read(i);
    }
    sequence.up();
    Sequence unposed(folder.path(), {.poses = PoseSource::None});  // takes what is listed
    unposed.set_poses(std::vector<std::optional<Eigen::Isometry3d>>(unposed.size(),
                                                                    Eigen::Isometry3d::Identity()));
  }

  void repair(const SequenceFile& file) { folders_[file.folder].write(file.name, file.sound); }

  std::array<ScratchFolder, 3> folders_;  // TUM, Redwood, frames
  const std::vector<SequenceFile> files_ = {
      {'d', 0, "depth.txt", "1.0 1.png\n"},
      {'g', 0, "groundtruth.txt", "1.0 0 0 0 0 0 0 1\n"},
      {'c', 0, "camera.txt", "4 3 3 3 1.5 1\n"},
      {'l', 1, "trajectory.log", std::string("0 0 1\n") + kPose},
      {'j', 1, "camera_intrinsic.json",
       R"({"width": 4, "height": 3, "intrinsic_matrix": [3, 0, 0, 0, 3, 0, 1.5, 1, 1]})"},
      {'p', 2, "frame-000000.pose.txt", kPose},
      {'i', 2, "info.txt",
       "m_depthWidth = 4\nm_depthHeight = 3\nm_depthShift = 1000\n"
       "m_calibrationDepthIntrinsic = 3 0 1.5 0 0 3 1 0 0 0 1 0 0 0 0 1\n"},
  };
};

}  // namespace

void fuzz(std::string_view bytes) {
  static Sequences sequences;
  if (!bytes.empty()) sequences.open_with(bytes.front(), bytes.substr(1));
}

}  // namespace planescope::fuzzing
