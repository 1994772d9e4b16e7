// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cli/odometry.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "cli/console.hpp"
#include "cli/run_info.hpp"
#include "planescope/error.hpp"
#include "planescope/odometry.hpp"

namespace planescope::cli {
namespace {

namespace fs = std::filesystem;

fs::path find_program() {
  const char* named = std::getenv("PLANESCOPE_ODOMETRY");
  if (named != nullptr && *named != '\0') return named;
  return fs::read_symlink("/proc/self/exe").parent_path() / "planescope-odometry";
}

/// Turns the world so that its z is up as the cameras were held on the whole: maps are looked at,
/// and fused in a grid that lies level.
void set_upright(Sequence& sequence) {
  const std::optional<Eigen::Vector3f> up = sequence.up();
  if (!up) return;
  const Eigen::Isometry3d turn(
      Eigen::Quaterniond::FromTwoVectors(up->cast<double>(), Eigen::Vector3d::UnitZ()));
  std::vector<std::optional<Eigen::Isometry3d>> poses;
  for (std::size_t i = 0; i < sequence.size(); ++i) poses.push_back(turn * sequence.info(i).pose);
  sequence.set_poses(poses);
}

/// `; lost: 3, 7-9`, by the frames' numbers; nothing where none is.
std::string lost_frames(const Sequence& sequence,
                        const std::vector<std::optional<Eigen::Isometry3d>>& poses) {
  constexpr std::size_t kMost = 20;  // of ranges that anyone reads
  std::string text;
  std::size_t ranges = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (poses[i]) continue;
    const std::size_t first = i;
    while (i + 1 < poses.size() && !poses[i + 1]) ++i;
    if (++ranges > kMost) return text + ", ...";
    text += text.empty() ? "; lost: " : ", ";
    text += std::to_string(sequence.info(first).number);
    if (i == first) continue;
    text += '-';
    text += std::to_string(sequence.info(i).number);
  }
  return text;
}

}  // namespace

void give_poses(Sequence& sequence, const Console& console) {
  if (sequence.size() == 1) {
    sequence.set_poses({Eigen::Isometry3d::Identity()});
    return set_upright(sequence);
  }
  const fs::path program = find_program();
  const std::string folder = sequence.folder().string();
  if (!fs::is_regular_file(program)) {
    throw Error(Error::Kind::Input,
                folder + ": has depth images but no poses, and " + program.string() +
                    ", which estimates them, is not there (it is built with libopen3d-dev); "
                    "expected groundtruth.txt (TUM), trajectory.log (Open3D), or "
                    "frame-*.pose.txt (7-Scenes)");
  }
  console.say("warning: " + folder +
              ": poses by RGB-D odometry, frame to frame: they drift, and slide where a view shows "
              "neither relief nor texture");
  Stopwatch watch;
  const auto matcher = start_open3d_matcher(program, sequence.camera());
  const auto poses = estimate_poses(sequence, *matcher, {}, console.progress());
  const std::string lost = lost_frames(sequence, poses);
  const std::size_t frames = sequence.size();
  sequence.set_poses(poses);
  set_upright(sequence);
  const double time = watch.lap();
  console.say("odometry: " + std::to_string(sequence.size()) + " of " + std::to_string(frames) +
              " frames have poses" + lost + "; " + duration(time) + ", " +
              duration(time / static_cast<double>(frames)) + " a frame");
}

}  // namespace planescope::cli
