// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/sequence.hpp"
#include "sequence/text_lines.hpp"

/// \file One function a layout: what its lists and file names say of the frames.
namespace planescope::sequence {

/// What is known of where a frame was seen from.
enum class PoseState {
  Known,
  Lost,    ///< the file has numbers for it that are not finite
  Absent,  ///< no pose belongs to it
};

struct ListedFrame {
  FrameInfo info;
  PoseState state = PoseState::Absent;
};

/// All frames that have a depth image, in order, numbered from 0; all of them PoseState::Absent
/// where options.poses is None. \throws Error{Kind::Input} a list is missing or cannot be read.
std::vector<ListedFrame> list_tum(const std::filesystem::path& folder,
                                  const SequenceOptions& options);
std::vector<ListedFrame> list_redwood(const std::filesystem::path& folder,
                                      const SequenceOptions& options);
std::vector<ListedFrame> list_frames(const std::filesystem::path& folder,
                                     const SequenceOptions& options);

/// The layout that the files of a folder show. \param with_poses its poses must be there too.
/// \throws Error{Kind::Input} none.
SequenceLayout detect_layout(const std::filesystem::path& folder, bool with_poses);

/// True where there is a file of poses, whatever it holds.
bool has_pose_files(const std::filesystem::path& folder, SequenceLayout layout);


/// Reads four lines of four numbers: camera to world.
/// \returns nothing where a number is not finite: tracking was lost.
/// \throws Error{Kind::Input} with the line: no numbers, or no rotation and translation.
std::optional<Eigen::Isometry3d> read_matrix(TextLines& lines);

/// A rotation from what a file has, made orthonormal; nothing where it is further than `tolerance`
/// from one.
std::optional<Eigen::Isometry3d> make_rigid(const Eigen::Matrix4d& matrix, double tolerance = 0.01);

/// Files of a folder whose name ends in one of the endings, in the order of the numbers in their
/// names.
std::vector<std::filesystem::path> list_files(const std::filesystem::path& folder,
                                              const std::vector<std::string>& endings);

}  // namespace planescope::sequence
