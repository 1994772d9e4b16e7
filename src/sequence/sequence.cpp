// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/sequence.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "planescope/error.hpp"
#include "planescope/result.hpp"
#include "sequence/find_camera.hpp"
#include "sequence/layouts.hpp"

namespace planescope {
namespace {

using sequence::ListedFrame;
using sequence::PoseState;

void require(bool holds, const std::string& what) {
  if (!holds) throw Error(Error::Kind::Usage, "sequence: " + what);
}

void validate(const SequenceOptions& options) {
  require(options.step >= 1 && options.first <= options.last,
          "frames " + std::to_string(options.first) + ":" + std::to_string(options.last) + ":" +
              std::to_string(options.step) + "; expected first:last:step, step at least 1");
  require(options.min_depth >= 0 && options.min_depth < options.max_depth,
          "depths from " + std::to_string(options.min_depth) + " to " +
              std::to_string(options.max_depth) + " m; expected the first below the second");
  require(!options.depth_scale || (*options.depth_scale > 0 && *options.depth_scale <= 1e6),
          "the depth scale; expected more than 0, at most 1e6 units a metre");
  require(options.max_time_difference > 0, "the time difference; expected more than 0 s");
}

std::vector<ListedFrame> list(const std::filesystem::path& folder, SequenceLayout layout,
                              const SequenceOptions& options) {
  switch (layout) {
    case SequenceLayout::Tum:
      return sequence::list_tum(folder, options);
    case SequenceLayout::Redwood:
      return sequence::list_redwood(folder, options);
    case SequenceLayout::Frames:
      return sequence::list_frames(folder, options);
  }
  throw Error(Error::Kind::Internal, "a layout without a reader");
}

std::string size_text(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

bool in_range(std::uint32_t number, const SequenceOptions& options) {
  return number >= options.first && number <= options.last &&
         (number - options.first) % options.step == 0;
}

}  // namespace

std::string_view name(SequenceLayout layout) {
  constexpr std::array<std::string_view, 3> kNames = {"tum", "redwood", "frames"};
  return kNames[static_cast<std::size_t>(layout)];
}

Sequence::Sequence(const std::filesystem::path& folder, const SequenceOptions& options)
    : folder_(folder), color_(options.color) {
  validate(options);
  const bool must_have_poses = options.poses == PoseSource::Files;
  layout_ = options.layout ? *options.layout : sequence::detect_layout(folder, must_have_poses);
  has_poses_ = must_have_poses || (options.poses == PoseSource::FilesIfThere &&
                                   sequence::has_pose_files(folder, layout_));
  estimated_ = !has_poses_;
  SequenceOptions wish = options;
  wish.poses = has_poses_ ? PoseSource::Files : PoseSource::None;
  take_frames(list(folder, layout_, wish), options);
  find_camera(options);
}

void Sequence::take_frames(const std::vector<sequence::ListedFrame>& listed,
                           const SequenceOptions& options) {
  std::size_t wanted = 0;
  for (const ListedFrame& frame : listed) {
    if (!in_range(frame.info.number, options)) continue;
    ++wanted;
    if (frame.state == PoseState::Known || !has_poses_) frames_.push_back(frame.info);
    if (!has_poses_) continue;
    lost_ += frame.state == PoseState::Lost ? 1 : 0;
    unposed_ += frame.state == PoseState::Absent ? 1 : 0;
  }
  if (frames_.empty()) {
    throw Error(Error::Kind::Input,
                folder_.string() + ": none of " + std::to_string(wanted) + " frames (of " +
                    std::to_string(listed.size()) + ") has depth and pose: " +
                    std::to_string(lost_) + " lost their track, " + std::to_string(unposed_) +
                    " have no pose" + (layout_ == SequenceLayout::Tum ? " near in time" : ""));
  }
}

void Sequence::set_poses(const std::vector<std::optional<Eigen::Isometry3d>>& poses) {
  require(poses.size() == frames_.size(), std::to_string(poses.size()) + " poses for " +
                                              std::to_string(frames_.size()) +
                                              " frames; expected one each");
  std::vector<FrameInfo> posed;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i]) continue;
    posed.push_back(frames_[i]);
    posed.back().pose = *poses[i];
  }
  require(!posed.empty(), "no frame has a pose; expected one at least");
  lost_ += frames_.size() - posed.size();
  frames_ = std::move(posed);
  has_poses_ = estimated_ = true;
}

void Sequence::find_camera(const SequenceOptions& options) {
  CameraFile found;
  if (options.lens) {
    found.lens = *options.lens;
    camera_source_ = "as given";
  }
  if (!options.lens || !options.depth_scale) {  // the file may hold the one that is not given
    sequence::FoundCamera own = sequence::find_camera(folder_, layout_);
    if (!options.lens) found.lens = own.camera.lens;
    if (!options.lens) camera_source_ = own.source;
    found.depth_scale = own.camera.depth_scale;
  }
  const double usual = layout_ == SequenceLayout::Tum ? 5000 : 1000;
  camera_.lens = found.lens;
  camera_.depth_scale = options.depth_scale.value_or(found.depth_scale.value_or(usual));
  camera_.min_depth = options.min_depth;
  camera_.max_depth = options.max_depth;
  if (camera_.lens.width == 0) {
    const DepthImage first = read_depth_image(frames_.front().depth);
    camera_.lens.width = first.width;
    camera_.lens.height = first.height;
  }
  check_lens();
}

/// The axis may leave a picture that was cut out of a larger one, but not by far.
void Sequence::check_lens() const {
  const PinholeCamera& lens = camera_.lens;
  const auto is_near = [](double at, std::uint32_t size) {
    return at > -1.0 * size && at < 2.0 * size;
  };
  if (is_near(lens.cx, lens.width) && is_near(lens.cy, lens.height)) return;
  throw Error(Error::Kind::Input,
              folder_.string() + ": the camera (" + camera_source_ + ") looks along pixel " +
                  std::to_string(lens.cx) + ", " + std::to_string(lens.cy) + " of " +
                  size_text(lens.width, lens.height) +
                  "; expected cx and cy in the image; are the --intrinsics FX,FY,CX,CY?");
}

Frame Sequence::read(std::size_t i) const {
  Frame frame{frames_.at(i), {}, {}};
  frame.depth = read_depth_image(frame.info.depth);
  const PinholeCamera& lens = camera_.lens;
  if (frame.depth.width != lens.width || frame.depth.height != lens.height) {
    throw Error(Error::Kind::Input, frame.info.depth.string() + ": is " +
                                        size_text(frame.depth.width, frame.depth.height) +
                                        " pixels, the camera (" + camera_source_ + ") " +
                                        size_text(lens.width, lens.height) +
                                        "; expected the same size, or --intrinsics");
  }
  if (!color_ || frame.info.color.empty()) return frame;
  frame.color = read_color_image(frame.info.color);
  if (frame.color.width != lens.width || frame.color.height != lens.height) {
    throw Error(Error::Kind::Input, frame.info.color.string() + ": is " +
                                        size_text(frame.color.width, frame.color.height) +
                                        " pixels, its depth " + size_text(lens.width, lens.height) +
                                        "; expected colour registered to depth, or --no-color");
  }
  return frame;
}

std::optional<Eigen::Vector3f> Sequence::up() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const FrameInfo& frame : frames_) sum -= frame.pose.linear().col(1);  // y is down
  if (sum.norm() < 0.3 * static_cast<double>(frames_.size())) return std::nullopt;
  return sum.normalized().cast<float>();
}

std::string Sequence::hash() const {
  std::string text;
  for (const FrameInfo& frame : frames_) {
    text += frame.depth.filename().string();
    text += hash_file(frame.depth);
    if (!frame.color.empty()) text += hash_file(frame.color);
    const auto& pose = frame.pose.matrix();
    text.append(reinterpret_cast<const char*>(pose.data()), 16 * sizeof(double));
  }
  const PinholeCamera& lens = camera_.lens;
  const std::array<double, 7> camera = {
      lens.fx,           lens.fy,          lens.cx, lens.cy, camera_.depth_scale,
      camera_.min_depth, camera_.max_depth};
  text.append(reinterpret_cast<const char*>(camera.data()), sizeof camera);
  return hash_text(text);
}

}  // namespace planescope
