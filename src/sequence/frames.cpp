// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "sequence/layouts.hpp"

namespace planescope::sequence {

std::vector<ListedFrame> list_frames(const std::filesystem::path& folder,
                                     const SequenceOptions& options) {
  namespace fs = std::filesystem;
  constexpr std::string_view kDepth = ".depth.png";
  std::vector<ListedFrame> frames;
  for (const fs::path& depth : list_files(folder, {std::string(kDepth)})) {
    ListedFrame& frame = frames.emplace_back();
    frame.info.number = static_cast<std::uint32_t>(frames.size() - 1);
    frame.info.depth = depth;
    std::string stem = depth.string();
    stem.resize(stem.size() - kDepth.size());
    for (const char* ending : {".color.png", ".color.jpg", ".color.jpeg"}) {
      if (options.color && frame.info.color.empty() && fs::exists(stem + ending)) {
        frame.info.color = stem + ending;
      }
    }
    if (options.poses == PoseSource::None || !fs::exists(stem + ".pose.txt")) continue;
    TextLines lines(stem + ".pose.txt", "a pose: 4 lines of 4 numbers");
    const std::optional<Eigen::Isometry3d> pose = read_matrix(lines);
    frame.state = pose ? PoseState::Known : PoseState::Lost;
    if (pose) frame.info.pose = *pose;
  }
  return frames;
}

}  // namespace planescope::sequence
