// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "planescope/error.hpp"
#include "sequence/layouts.hpp"

namespace planescope::sequence {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> list_colors(const fs::path& folder) {
  for (const char* name : {"image", "color", "rgb"}) {
    if (fs::is_directory(folder / name)) {
      return list_files(folder / name, {".png", ".jpg", ".jpeg"});
    }
  }
  return {};
}

/// Colours of the same name as the depth; where no name is in common, of the same place in the
/// list.
void add_colors(const fs::path& folder, std::vector<ListedFrame>& frames) {
  const std::vector<fs::path> colors = list_colors(folder);
  std::map<std::string, fs::path> by_name;
  for (const fs::path& color : colors) by_name.emplace(color.stem().string(), color);
  bool any = false;
  for (ListedFrame& frame : frames) {
    const auto found = by_name.find(frame.info.depth.stem().string());
    if (found == by_name.end()) continue;
    frame.info.color = found->second;
    any = true;
  }
  if (any || colors.empty()) return;
  if (colors.size() != frames.size()) {
    throw Error(Error::Kind::Input, folder.string() + ": " + std::to_string(colors.size()) +
                                        " colour images for " + std::to_string(frames.size()) +
                                        " depth images, and no name in common; expected one each, "
                                        "or --no-color");
  }
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i].info.color = colors[i];
}

/// Entries of a head `frame frame next` and a matrix of four lines.
void add_poses(const fs::path& file, std::vector<ListedFrame>& frames) {
  TextLines lines(file, "poses of five lines each, as Open3D writes them");
  while (lines.next()) {
    lines.require(3, "3 numbers: the head of a pose");
    const double index = lines.number(0);
    if (!(index >= 0 && index < static_cast<double>(frames.size())) || index != std::floor(index)) {
      lines.fail("the pose of frame " + std::string(lines.words()[0]) +
                 " has no depth image: there are " + std::to_string(frames.size()));
    }
    ListedFrame& frame = frames[static_cast<std::size_t>(index)];
    if (frame.state != PoseState::Absent) lines.fail("a second pose of the same frame");
    const std::optional<Eigen::Isometry3d> pose = read_matrix(lines);
    frame.state = pose ? PoseState::Known : PoseState::Lost;
    if (pose) frame.info.pose = *pose;
  }
}

}  // namespace

std::vector<ListedFrame> list_redwood(const fs::path& folder, const SequenceOptions& options) {
  std::vector<ListedFrame> frames;
  for (const fs::path& depth : list_files(folder / "depth", {".png"})) {
    ListedFrame& frame = frames.emplace_back();
    frame.info.number = static_cast<std::uint32_t>(frames.size() - 1);
    frame.info.depth = depth;
  }
  if (frames.empty()) {
    throw Error(Error::Kind::Input, (folder / "depth").string() +
                                        ": holds no PNG; expected depth "
                                        "images");
  }
  if (options.poses != PoseSource::None) add_poses(folder / "trajectory.log", frames);
  if (options.color) add_colors(folder, frames);
  return frames;
}

}  // namespace planescope::sequence
