// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/options.hpp"
#include "planescope/sequence.hpp"

/// \file RGB-D odometry: poses for a sequence that has none. Frame is put to frame, so that errors
/// add up: the map drifts, and slides along what shows neither relief nor texture.
namespace planescope {

/// How a frame fits one before it.
struct FrameMatch {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();  ///< its camera to the other's
  double share = 0;  ///< of its returns that then lie on a return of the other frame, [0, 1]
};

/// Puts frames to each other, two at a time.
class FrameMatcher {
 public:
  virtual ~FrameMatcher() = default;

  /// The frame that match() puts to the one kept.
  virtual void take(const Frame& frame) = 0;
  /// Keeps the frame that was taken last: later ones are put to it.
  virtual void keep() = 0;
  /// \param guess where the search for the motion begins.
  /// \returns nothing where it finds none. \throws Error{Kind::Computation} the matcher is broken.
  virtual std::optional<FrameMatch> match(const Eigen::Isometry3d& guess) = 0;
};

/// Open3D's ComputeRGBDOdometry with its hybrid term (colour and depth; depth alone for frames
/// without colour; Park, Zhou, Koltun, "Colored Point Cloud Registration Revisited", ICCV 2017). It
/// works in a process of its own, the program planescope-odometry: Open3D comes with a hundred
/// libraries, and whatever befalls it there is an Error here. It takes one thread and gives the
/// same bits anywhere. The process ends with the matcher. \param program planescope-odometry.
/// \param patience [s] for one answer. \throws Error{Kind::Computation} the program cannot be
/// started, or does not answer.
std::unique_ptr<FrameMatcher> start_open3d_matcher(const std::filesystem::path& program,
                                                   const DepthCamera& camera, double patience = 60);

/// When a motion is believed. Relief and texture are those of src/odometry/observability.hpp; their
/// values were chosen on a synthesized walk through a bare room (`synthesize --sequence 300`), so
/// that motions along walls, which slide by decimetres, are not.
struct OdometryOptions {
  double min_share = 0.5;     ///< of FrameMatch::share
  double min_relief = 0.03;   ///< a frame has this much relief,
  double min_texture = 0.3;   ///< or this much texture [1/m^2]
  double max_distance = 0.5;  ///< [m] a frame of the sequence (those that were left out count)
  double max_angle = 30;      ///< [deg] a frame of the sequence, likewise
};

/// Poses by putting each frame to the last one that fitted: first where the motion so far goes on,
/// and, unless that fits well, where the camera stood still. A frame that does not fit is lost, and
/// so is one that shows neither relief nor texture enough to be placed by; after five that do not
/// fit (after one where nothing fitted yet) a new chain begins. The longest chain has the poses;
/// the world is its first camera. Reports `odometry`. \returns one entry a frame: camera to world,
/// or nothing where the frame is lost. \throws Error as Sequence::read() and the matcher do;
/// Error{Kind::Computation} of two or more frames no two fit each other.
std::vector<std::optional<Eigen::Isometry3d>> estimate_poses(const Sequence& sequence,
                                                             FrameMatcher& matcher,
                                                             const OdometryOptions& options = {},
                                                             const Progress& progress = {});

}  // namespace planescope
