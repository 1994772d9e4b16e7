// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <string>

#include "sequence/layouts.hpp"

namespace planescope::sequence {
namespace {

struct TimedFile {
  double time;
  std::filesystem::path file;
};

struct TimedPose {
  double time;
  std::optional<Eigen::Isometry3d> pose;  // nothing: tracking was lost
};

double read_time(const TextLines& lines) {
  const double time = lines.number(0);
  if (!std::isfinite(time)) lines.fail("the time stamp is not finite");
  return time;
}

template <class Timed>
void sort_by_time(std::vector<Timed>& list) {
  std::ranges::stable_sort(list, {}, &Timed::time);
}

std::vector<TimedFile> read_list(const std::filesystem::path& folder, const char* name) {
  TextLines lines(folder / name, "a list `time file`, as of TUM RGB-D");
  std::vector<TimedFile> list;
  while (lines.next()) {
    lines.require(2, "`time file`");
    list.push_back({read_time(lines), folder / std::filesystem::path(lines.words()[1])});
  }
  sort_by_time(list);
  return list;
}

std::vector<TimedPose> read_poses(const std::filesystem::path& file) {
  TextLines lines(file, "poses `time tx ty tz qx qy qz qw`, as of TUM RGB-D");
  std::vector<TimedPose> poses;
  while (lines.next()) {
    lines.require(8, "`time tx ty tz qx qy qz qw`");
    TimedPose& entry = poses.emplace_back(TimedPose{read_time(lines), {}});
    Eigen::Matrix<double, 7, 1> v;
    for (int i = 0; i < 7; ++i) v[i] = lines.number(static_cast<std::size_t>(i) + 1);
    if (!v.allFinite()) continue;
    const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
    if (std::abs(q.norm() - 1) > 0.01) lines.fail("the quaternion is not of length 1");
    if (v.head<3>().cwiseAbs().maxCoeff() > 1e7) lines.fail("the position is beyond 1e7 m");
    entry.pose = Eigen::Translation3d(v.head<3>()) * q.normalized();
  }
  sort_by_time(poses);
  return poses;
}

/// The entry nearest in time, of equals the earlier one.
template <class Timed>
const Timed* find_nearest(const std::vector<Timed>& list, double time, double most) {
  const auto after = std::ranges::lower_bound(list, time, {}, &Timed::time);
  const Timed* best = nullptr;
  for (auto it = after == list.begin() ? after : after - 1; it != list.end(); ++it) {
    const double difference = std::abs(it->time - time);
    if (difference <= most && (!best || difference < std::abs(best->time - time))) best = &*it;
    if (it->time >= time) break;
  }
  return best;
}

/// The pose at a time: between the poses before and after it where both are near, because a hand
/// moves on by millimetres within the hundredth of a second between them; else the nearest.
void find_pose(const std::vector<TimedPose>& poses, double time, double most, ListedFrame& frame) {
  const TimedPose* nearest = find_nearest(poses, time, most);
  if (nearest == nullptr) return;
  frame.state = nearest->pose ? PoseState::Known : PoseState::Lost;
  if (!nearest->pose) return;
  frame.info.pose = *nearest->pose;
  const auto after = std::ranges::lower_bound(poses, time, {}, &TimedPose::time);
  if (after == poses.end() || after == poses.begin()) return;
  const TimedPose &a = *(after - 1), &b = *after;
  const bool both_near = time - a.time <= most && b.time - time <= most && b.time > a.time;
  if (!both_near || !a.pose || !b.pose) return;
  const double t = (time - a.time) / (b.time - a.time);
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(a.pose->linear()).slerp(t, Eigen::Quaterniond(b.pose->linear()));
  const Eigen::Vector3d place = (1 - t) * a.pose->translation() + t * b.pose->translation();
  frame.info.pose = Eigen::Translation3d(place) * turn;
}

}  // namespace

std::vector<ListedFrame> list_tum(const std::filesystem::path& folder,
                                  const SequenceOptions& options) {
  const std::vector<TimedFile> depths = read_list(folder, "depth.txt");
  std::vector<TimedPose> poses;
  if (options.poses != PoseSource::None) poses = read_poses(folder / "groundtruth.txt");
  std::vector<TimedFile> colors;
  if (options.color && std::filesystem::exists(folder / "rgb.txt")) {
    colors = read_list(folder, "rgb.txt");
  }
  std::vector<ListedFrame> frames;
  for (const TimedFile& depth : depths) {
    ListedFrame& frame = frames.emplace_back();
    frame.info.number = static_cast<std::uint32_t>(frames.size() - 1);
    frame.info.time = depth.time;
    frame.info.depth = depth.file;
    const TimedFile* color = find_nearest(colors, depth.time, options.max_time_difference);
    if (color != nullptr) frame.info.color = color->file;
    find_pose(poses, depth.time, options.max_time_difference, frame);
  }
  return frames;
}

}  // namespace planescope::sequence
