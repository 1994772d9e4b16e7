// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>

#include "io/whole_file.hpp"
#include "planescope/error.hpp"
#include "planescope/sequence.hpp"

namespace planescope {
namespace {

/// An entry of Redwood's trajectory.log, five lines; numbers with all their digits.
std::string redwood_entry(const FrameInfo& frame) {
  const std::uint32_t k = frame.number;
  std::string entry =
      std::to_string(k) + " " + std::to_string(k) + " " + std::to_string(k + 1) + "\n";
  char text[128];
  for (int row = 0; row < 4; ++row) {
    const auto& m = frame.pose.matrix();
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g %.17g\n", m(row, 0), m(row, 1), m(row, 2),
                  m(row, 3));
    entry += text;
  }
  return entry;
}

std::string tum_line(const FrameInfo& frame) {
  const Eigen::Vector3d t = frame.pose.translation();
  const Eigen::Quaterniond q(frame.pose.linear());
  char text[320];
  std::snprintf(text, sizeof text, "%.9f %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", frame.time,
                t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  return text;
}

}  // namespace

void check_trajectory_name(const std::filesystem::path& file, SequenceLayout layout) {
  const bool log = file.extension() == ".log";
  if (!log && file.extension() != ".txt") {
    throw Error(Error::Kind::Usage,
                file.string() + ": no trajectory's name; expected *.log (Redwood) or *.txt (TUM)");
  }
  if (!log && layout != SequenceLayout::Tum) {
    throw Error(Error::Kind::Usage,
                file.string() + ": the sequence has no times, which *.txt needs; expected *.log");
  }
}

void write_trajectory(const Sequence& sequence, const std::filesystem::path& file) {
  check_trajectory_name(file, sequence.layout());
  const bool log = file.extension() == ".log";
  std::string text = log ? "" : "# time tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const FrameInfo& frame = sequence.info(i);
    text += log ? redwood_entry(frame) : tum_line(frame);
  }
  write_whole(file, text);
}

}  // namespace planescope
