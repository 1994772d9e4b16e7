// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>

#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "sequence/layouts.hpp"

namespace planescope {
namespace sequence {

std::string trajectory_entry(std::uint32_t frame, const Eigen::Isometry3d& pose) {
  char text[256];
  std::snprintf(text, sizeof text, "%u %u %u\n", frame, frame, frame + 1);
  std::string entry = text;
  for (int row = 0; row < 4; ++row) {
    const auto& m = pose.matrix();
    std::snprintf(text, sizeof text, "%.10f %.10f %.10f %.10f\n", m(row, 0) + 0.0, m(row, 1) + 0.0,
                  m(row, 2) + 0.0, m(row, 3) + 0.0);
    entry += text;
  }
  return entry;
}

}  // namespace sequence

namespace {

std::string tum_line(const FrameInfo& frame) {
  const Eigen::Vector3d t = frame.pose.translation();
  const Eigen::Quaterniond q(frame.pose.linear());
  char text[320];
  std::snprintf(text, sizeof text, "%.6f %.10f %.10f %.10f %.10f %.10f %.10f %.10f\n", frame.time,
                t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  return text;
}

}  // namespace

void write_trajectory(const Sequence& sequence, const std::filesystem::path& file) {
  const bool log = file.extension() == ".log";
  if (!log && file.extension() != ".txt") {
    throw Error(Error::Kind::Usage,
                file.string() + ": no trajectory's name; expected *.log (Redwood) or *.txt (TUM)");
  }
  std::string text = log ? "" : "# time tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const FrameInfo& frame = sequence.info(i);
    text += log ? sequence::trajectory_entry(frame.number, frame.pose) : tum_line(frame);
  }
  write_whole(file, text);
}

}  // namespace planescope
