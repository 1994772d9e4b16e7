// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "odometry/observability.hpp"
#include "planescope/error.hpp"
#include "planescope/odometry.hpp"
#include "sequence/read_ahead.hpp"

namespace planescope {
namespace {

constexpr double kFitsWell = 0.6;     // of the share: no other guess is tried
constexpr std::size_t kPatience = 5;  // frames lost in a row, then a new chain

/// Frames of which each was put to one before it.
struct Chain {
  std::vector<std::pair<std::size_t, Eigen::Isometry3d>> poses;  // frame, camera to world
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();        // the last motion, a frame

  explicit Chain(std::size_t first) : poses{{first, Eigen::Isometry3d::Identity()}} {}

  std::size_t last() const { return poses.back().first; }

  void add(std::size_t frame, const Eigen::Isometry3d& motion) {
    const std::size_t frames = frame - last();
    Eigen::Isometry3d pose = poses.back().second * motion;
    pose.linear() = Eigen::Quaterniond(pose.linear()).normalized().toRotationMatrix();
    poses.emplace_back(frame, pose);
    // over a gap the motion is not known frame by frame
    step = frames == 1 ? motion : Eigen::Isometry3d::Identity();
  }

  /// Where the camera is now if it goes on as it did.
  Eigen::Isometry3d guess(std::size_t frame) const {
    Eigen::Isometry3d motion = step;
    for (std::size_t k = last() + 1; k < frame; ++k) motion = motion * step;
    return motion;
  }
};

/// Frames that show too little are not matched, nor others to them.
bool shows_enough(const Frame& frame, const DepthCamera& camera, const OdometryOptions& options) {
  const odometry::Observability view = odometry::observe(frame, camera);
  return view.relief >= options.min_relief || view.texture >= options.min_texture;
}

/// The longest, of equals the first. \throws Error{Kind::Computation} it is no chain.
const Chain& longest_chain(const std::vector<Chain>& chains, const Sequence& sequence) {
  const std::string whose =
      sequence.folder().string() + ": odometry: of " + std::to_string(sequence.size()) + " frames ";
  if (chains.empty()) {
    throw Error(Error::Kind::Computation,
                whose +
                    "none shows relief or texture enough to find the camera by; are there depths "
                    "between --min-depth and --max-depth, at this --depth-scale?");
  }
  const auto shorter = [](const Chain& a, const Chain& b) {
    return a.poses.size() < b.poses.size();
  };
  const Chain& longest = *std::ranges::max_element(chains, shorter);
  if (sequence.size() > 1 && longest.poses.size() == 1) {
    throw Error(Error::Kind::Computation,
                whose +
                    "no two in a row fit each other; expected small steps between frames, and "
                    "the right --intrinsics and --depth-scale");
  }
  return longest;
}

bool is_believed(const FrameMatch& match, std::uint32_t frames, const OdometryOptions& options) {
  const double angle = Eigen::AngleAxisd(match.motion.linear()).angle() * 180 / std::numbers::pi;
  return match.share >= options.min_share &&
         match.motion.translation().norm() <= options.max_distance * frames &&
         std::abs(angle) <= options.max_angle * frames;
}

/// The better of the two guesses' outcomes that can be believed.
std::optional<FrameMatch> find_motion(FrameMatcher& matcher, const Eigen::Isometry3d& guess,
                                      std::uint32_t frames, const OdometryOptions& options) {
  std::optional<FrameMatch> best;
  for (const Eigen::Isometry3d& start : {guess, Eigen::Isometry3d::Identity()}) {
    if (best && best->share >= kFitsWell) break;
    const std::optional<FrameMatch> found = matcher.match(start);
    if (!found || !is_believed(*found, frames, options)) continue;
    if (!best || found->share > best->share) best = found;
  }
  return best;
}

/// Puts the frame that the matcher took to the last one of the chain, or begins a new chain.
void put_to(std::vector<Chain>& chains, std::size_t frame, std::uint32_t frames,
            FrameMatcher& matcher, const OdometryOptions& options) {
  Chain& chain = chains.back();
  const auto found = find_motion(matcher, chain.guess(frame), frames, options);
  if (found) {
    chain.add(frame, found->motion);
  } else if (chain.poses.size() == 1 || frame - chain.last() > kPatience) {
    chains.emplace_back(frame);
  } else {
    return;  // lost
  }
  matcher.keep();
}

}  // namespace

std::vector<std::optional<Eigen::Isometry3d>> estimate_poses(const Sequence& sequence,
                                                             FrameMatcher& matcher,
                                                             const OdometryOptions& options,
                                                             const Progress& progress) {
  std::vector<Chain> chains;
  sequence::for_each_frame(sequence, "odometry", progress, [&](std::size_t i, const Frame& frame) {
    if (!shows_enough(frame, sequence.camera(), options)) return;
    matcher.take(frame);
    if (chains.empty()) {
      chains.emplace_back(i);
      return matcher.keep();
    }
    const std::uint32_t before = sequence.info(chains.back().last()).number;
    put_to(chains, i, frame.info.number - before, matcher, options);
  });
  std::vector<std::optional<Eigen::Isometry3d>> poses(sequence.size());
  for (const auto& [frame, pose] : longest_chain(chains, sequence).poses) poses[frame] = pose;
  return poses;
}

}  // namespace planescope
