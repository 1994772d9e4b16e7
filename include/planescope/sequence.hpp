// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/cloud.hpp"
#include "planescope/image.hpp"
#include "planescope/project.hpp"

/// \file RGB-D sequences: depth images with colours and poses, one reader over the layouts that
/// people have. Folders are untrusted.
namespace planescope {

namespace sequence {
struct ListedFrame;
}

/// A depth camera: how pixels and stored depths become points.
struct DepthCamera {
  PinholeCamera lens;         ///< its width, height and intrinsics; the pose is not used
  double depth_scale = 1000;  ///< stored units a metre
  double min_depth = 0;       ///< [m] nearer returns are left out
  double max_depth = 1e9;     ///< [m] farther returns are left out

  /// Depth of a stored value [m]; 0 where there is no return or it is out of range.
  double depth(std::uint16_t value) const noexcept {
    if (value == 0 || value == std::numeric_limits<std::uint16_t>::max()) return 0;
    const double z = value / depth_scale;
    return z < min_depth || z > max_depth ? 0 : z;
  }
};

/// Intrinsics by name: `primesense` (525, 525, 319.5, 239.5: TUM's default, Redwood, Kinect),
/// `tum_fr1`, `tum_fr2`, `tum_fr3`, `7scenes`, `icl_nuim`.
/// \throws Error{Kind::Usage} no such name.
PinholeCamera named_camera(std::string_view name);

/// The names that named_camera() takes.
std::vector<std::string> camera_names();

/// A camera from a file: Open3D's JSON (`width`, `height`, `intrinsic_matrix` by columns), or one
/// line of text `width height fx fy cx cy [depth_scale]`; lines that start with # do not count.
struct CameraFile {
  PinholeCamera lens;
  std::optional<double> depth_scale;  ///< stored units a metre, where the file says so
};
/// \throws Error{Kind::Input} missing, malformed, or no camera (focal lengths, sizes).
CameraFile read_camera_file(const std::filesystem::path& file);

/// An organised cloud of a depth image in the camera's frame (x right, y down, z forward): the
/// sensor at (0, 0, 0), NaN where there is no return.
/// \param color of the same size, or empty.
/// \throws Error{Kind::Usage} the images or the camera differ in size.
PointCloud unproject(const DepthImage& depth, const ColorImage& color, const DepthCamera& camera);

/// How the files of a sequence are laid out.
enum class SequenceLayout {
  Tum,      ///< depth.txt, groundtruth.txt, [rgb.txt]: associated by time; 5000 units a metre
  Redwood,  ///< depth/, [image/ | color/ | rgb/], trajectory.log (Open3D); 1000 units a metre
  Frames,   ///< frame-NNNNNN.depth.png, .pose.txt, [.color.*] (7-Scenes, BundleFusion); 1000
};
std::string_view name(SequenceLayout layout);  ///< `tum`, `redwood`, `frames`

/// Where the poses of a sequence are from.
enum class PoseSource {
  Files,         ///< its files, which must be there
  FilesIfThere,  ///< likewise, but where none of them is there all frames are taken, without poses
  None,          ///< all frames are taken, without poses
};

/// How to read a sequence. What is not given comes from the sequence's files.
struct SequenceOptions {
  std::optional<SequenceLayout> layout = {};  ///< else by the files that are there
  /// Width 0: of the images' size. Else camera.txt, camera_intrinsic.json or info.txt
  /// (BundleFusion) say; else it is what is usual for the layout.
  std::optional<PinholeCamera> lens = {};
  std::optional<double> depth_scale = {};  ///< [unit/m]; else the file's, else what is usual
  double min_depth = 0.1;                  ///< [m]
  double max_depth = 1e9;                  ///< [m]
  bool color = true;                       ///< false: colour images are not read
  PoseSource poses = PoseSource::Files;    ///< without them: estimate_poses(), set_poses()
  std::uint32_t first = 0;                 ///< first frame that is used, by number from 0
  std::uint32_t last = std::numeric_limits<std::uint32_t>::max();  ///< last one, itself included
  std::uint32_t step = 1;                                          ///< every so many
  double max_time_difference = 0.02;  ///< [s] Tum: frames, colours and poses further apart in time
                                      ///< do not belong together
};

/// One frame as the sequence lists it.
struct FrameInfo {
  std::uint32_t number = 0;     ///< in the sequence, from 0, before any was left out
  double time = 0;              ///< [s] Tum: its time stamp
  std::filesystem::path depth;  ///< file
  std::filesystem::path color;  ///< file; empty: the frame has none
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< camera to world
};

/// One frame as it was read.
struct Frame {
  FrameInfo info;
  DepthImage depth;
  ColorImage color;  ///< of the depth's size, or empty
};

/// A sequence: its camera and the frames that have a depth image and a pose (with has_poses()
/// false: all that have a depth image; their poses are the identity until set_poses()).
class Sequence {
 public:
  /// Reads the lists and poses; images only when they are asked for.
  /// \throws Error{Kind::Input} no folder, no layout that is known, a list or pose that cannot be
  /// read (with its line), no frame with depth and pose; \throws Error{Kind::Usage} options are out
  /// of range.
  Sequence(const std::filesystem::path& folder, const SequenceOptions& options = {});

  std::size_t size() const noexcept { return frames_.size(); }
  const FrameInfo& info(std::size_t i) const { return frames_.at(i); }
  const DepthCamera& camera() const noexcept { return camera_; }
  SequenceLayout layout() const noexcept { return layout_; }
  const std::filesystem::path& folder() const noexcept { return folder_; }

  /// Colour images are read, where there are any.
  bool with_color() const noexcept { return color_; }

  /// The frames' poses are known: from files, or by set_poses().
  bool has_poses() const noexcept { return has_poses_; }
  /// The poses are not the files': they came, or are to come, by set_poses().
  bool poses_are_estimated() const noexcept { return estimated_; }
  /// Gives each frame its pose; those without leave the sequence and count as lost().
  /// \param poses camera to world, one a frame.
  /// \throws Error{Kind::Usage} another number of poses than size(), or no frame has one.
  void set_poses(const std::vector<std::optional<Eigen::Isometry3d>>& poses);

  /// Frames left out: their pose is not finite ("tracking lost").
  std::size_t lost() const noexcept { return lost_; }
  /// Frames left out: no pose, or (Tum) none near enough in time.
  std::size_t unposed() const noexcept { return unposed_; }
  /// Where the camera's intrinsics are from, in words.
  const std::string& camera_source() const noexcept { return camera_source_; }

  /// Up in the world, unit: the mean of what was up in the frames' pictures, because cameras are
  /// held upright on the whole. Nothing where they were turned about evenly.
  std::optional<Eigen::Vector3f> up() const;

  /// Reads a frame's images. \throws Error{Kind::Input} one is missing, damaged, or of another size
  /// than the camera's (colours: than the depth's).
  Frame read(std::size_t i) const;

  /// hash_text() over names, bytes and poses of all frames: tells sequences apart.
  std::string hash() const;

 private:
  void take_frames(const std::vector<sequence::ListedFrame>& listed,
                   const SequenceOptions& options);
  void find_camera(const SequenceOptions& options);
  void check_lens() const;

  std::filesystem::path folder_;
  SequenceLayout layout_ = SequenceLayout::Tum;
  DepthCamera camera_;
  std::string camera_source_;
  bool color_ = true, has_poses_ = true, estimated_ = false;
  std::vector<FrameInfo> frames_;
  std::size_t lost_ = 0, unposed_ = 0;
};

/// Writes the frames' poses, whole or not at all: `*.log` as Redwood's trajectory.log (the numbers
/// are the frames'; read again, the poses are the same bits), `*.txt` as TUM's `time tx ty tz qx qy
/// qz qw`. \throws Error{Kind::Usage} another ending, or *.txt where the frames have no
/// times; Error{Kind::Input} it cannot be written.
void write_trajectory(const Sequence& sequence, const std::filesystem::path& file);
/// The check of its name alone, before work is done for it. \throws Error{Kind::Usage} likewise.
void check_trajectory_name(const std::filesystem::path& file, SequenceLayout layout);

}  // namespace planescope
