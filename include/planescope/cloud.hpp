// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

/// \file The point cloud that every stage reads, and the index conventions that all stages share.
namespace planescope {

/// "No patch", "no plane": indices into patches and planes are contiguous from 0, and this is their
/// absence.
inline constexpr std::int32_t kNone = -1;

/// Segment labels start at 1; 0 is "in no segment" (a non-finite point, or one that no patch
/// reached).
inline constexpr std::uint32_t kNoSegment = 0;

/// 8-bit colour, sRGB.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// A point cloud as it was read: same points, same order, non-finite ones in place.
/// `colors`, `normals`, `labels`, `radii` and `confidences` are either empty or have one entry a
/// point.
struct PointCloud {
  std::vector<Eigen::Vector3f> positions;  ///< [m], relative to `origin`; non-finite: no return
  std::vector<Rgb> colors;                 ///< own colours
  std::vector<Eigen::Vector3f> normals;  ///< unit, oriented towards the sensor; non-finite: unknown
  std::vector<std::uint32_t> labels;     ///< ground truth as the file has it; 0: none
  /// [m] of surfels: each point stands for a disc around its normal; NaN: unknown. Empty: points
  /// are no surfels.
  std::vector<float> radii = {};
  /// How sure each point is, in the mapper's own measure (ElasticFusion: about the number of frames
  /// that saw it); NaN: unknown. See leave_out_uncertain().
  std::vector<float> confidences = {};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< [m] world position = origin + position
  std::uint32_t width = 0;   ///< columns of an organised cloud; else the number of points
  std::uint32_t height = 1;  ///< rows of an organised cloud; else 1
  std::optional<Eigen::Vector3f>
      sensor;  ///< [m] sensor's position relative to `origin`, where known
  std::optional<Eigen::Vector3f> up = {};  ///< unit, roughly, where known: how cameras were held

  std::size_t size() const noexcept { return positions.size(); }
  bool organised() const noexcept { return height > 1; }
  bool has_colors() const noexcept { return !colors.empty(); }
  bool has_normals() const noexcept { return !normals.empty(); }
  bool has_labels() const noexcept { return !labels.empty(); }
  bool has_radii() const noexcept { return !radii.empty(); }
  bool has_confidences() const noexcept { return !confidences.empty(); }
};

/// True if x, y and z are all finite.
inline bool is_finite(const Eigen::Vector3f& p) noexcept {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

}  // namespace planescope
