// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/edges.hpp"
#include "planescope/options.hpp"
#include "planescope/patches.hpp"

/// \file Segments: connected components of ON edges.
namespace planescope {

/// One segment: a wall, a floor, an object. Its label is its index + 1: largest (in points) first.
struct Segment {
  std::uint32_t label = 0;     ///< 1 .. number of segments
  std::int32_t plane = kNone;  ///< its supporting plane, if it lies on one
  std::uint32_t patch_count = 0;
  std::uint32_t point_count = 0;
  float area = 0;                                      ///< [m^2]
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  ///< [m] mean of its points, by patches
};

/// The segments, and which one each patch belongs to.
struct SegmentSet {
  std::vector<Segment> segments;           ///< index = label - 1
  std::vector<std::uint32_t> patch_label;  ///< per patch: label, from 1
};

/// Union-find over ON edges; components smaller than `min_patches` join the neighbour with the
/// longest shared border.
SegmentSet connect_segments(const PatchGraph& graph, const std::vector<Edge>& edges,
                            const std::vector<PatchPlane>& patch_plane,
                            const SegmentOptions& options);

}  // namespace planescope
