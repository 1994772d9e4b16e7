// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "planescope/cloud.hpp"
#include "planescope/options.hpp"
#include "planescope/sequence.hpp"

/// \file Fusion of posed depth images into one surface: a truncated signed distance field (Curless
/// and Levoy, SIGGRAPH 1996; Newcombe et al., KinectFusion, ISMAR 2011) in hashed blocks of voxels
/// (Niessner et al., SIGGRAPH Asia 2013), on the CPU.
namespace planescope {

/// How to fuse.
struct FusionOptions {
  double voxel_size = 0.01;  ///< [m] 0.001 to 1
  double truncation = 0;     ///< [m] distances are kept up to this; at least 2 voxels; 0: 4 voxels
  std::uint32_t min_observations = 0;  ///< voxels seen in fewer frames make no surface, 1 to 255;
                                       ///< 0: 3, but 1 while fewer than 10 frames are fused
};

/// A surface as triangles.
struct Mesh {
  PointCloud vertices;  ///< with normals and, where the frames had them, colours
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices; counter-clockwise
                                                        ///< as seen by the sensor
};

/// A block of 8 x 8 x 8 voxels by its place: it starts at 8 voxel_size times this.
struct BlockKey {
  std::int32_t x = 0, y = 0, z = 0;
  // The zero of the comparison that the compiler writes is no pointer.
  // NOLINTNEXTLINE(modernize-use-nullptr)
  auto operator<=>(const BlockKey&) const = default;
};

/// The distance field. Same frames in the same order, same bits, at any number of threads. Memory
/// is that of the surface seen (about 10 kB a block), whatever the number of frames.
class TsdfVolume {
 public:
  /// \throws Error{Kind::Usage} options are out of range.
  explicit TsdfVolume(const FusionOptions& options = {});
  ~TsdfVolume();
  TsdfVolume(TsdfVolume&&) noexcept;
  TsdfVolume& operator=(TsdfVolume&&) noexcept;

  /// Fuses one frame: in each voxel near what its rays hit, the distance along the ray is averaged,
  /// weighted by the precision that the depth has. Surface that the frame looks through is worn
  /// away.
  /// \param color of the depth's size, or empty. \param pose camera to world.
  /// \throws Error{Kind::Usage} sizes differ; Error{Kind::Computation} the pose lies 2^20 blocks
  /// or more from the first one's.
  void integrate(const DepthImage& depth, const ColorImage& color, const DepthCamera& camera,
                 const Eigen::Isometry3d& pose);

  /// The surface as points, one in each cell that it passes, at the mean of where it crosses the
  /// cell's edges (surface nets: Gibson, MICCAI 1998), with unit normals: the field's gradient, so
  /// towards the sensors that saw it. Ordered by block, then by cell.
  /// \throws Error{Kind::Computation} there is no surface.
  PointCloud points() const;

  /// The same points, joined to triangles.
  Mesh mesh() const;

  std::uint32_t frames() const noexcept;          ///< fused so far
  std::size_t block_count() const noexcept;       ///< allocated
  const FusionOptions& options() const noexcept;  ///< truncation resolved
  /// [m] what positions are relative to: zero, or the first pose's whole metres where it lies more
  /// than 1 km from zero.
  const Eigen::Vector3d& origin() const noexcept;

  /// Blocks in which a frame since `frame` (itself included, from 0) changed anything; sorted.
  std::vector<BlockKey> changed_since(std::uint32_t frame) const;

  /// The points() that one block holds; empty where there is no such block or no surface in it.
  /// They depend on this block and its 7 neighbours towards +x, +y, +z.
  PointCloud block_points(const BlockKey& block) const;

  /// Writes the field as bytes (src/fusion/volume_file.cpp has the layout), about 6 kB a block
  /// without colours and 11 with: a volume that was read back goes on to the same bits. Check the
  /// stream afterwards.
  void write(std::ostream& to) const;
  /// Reads what write() wrote; untrusted. \param from can be sought in. \param name of the stream,
  /// for messages. \throws Error{Kind::Input} it is cut short, damaged, of another version or byte
  /// order.
  static TsdfVolume read(std::istream& from, const std::string& name);

 private:
  struct Field;
  std::unique_ptr<Field> field_;
};

/// Fuses all frames of a sequence, reading one while the last one is fused; reports `fusion`.
/// \throws Error as Sequence::read() and TsdfVolume do.
TsdfVolume fuse(const Sequence& sequence, const FusionOptions& options = {},
                const Progress& progress = {});

/// Writes a mesh as binary PLY, whole or not at all.
/// \throws Error{Kind::Input} it cannot be written.
void write_mesh(const Mesh& mesh, const std::filesystem::path& ply);

}  // namespace planescope
