// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "color_assignment.hpp"

/// \file One colour for one object, in all segmentations of a scene.
namespace planescope::draw {

/// Labels of a segmentation as objects that several segmentations share.
struct MatchedLabels {
  /// Per segmentation and label: the object, counted from 0. Label 0 has none (its entry is 0).
  std::vector<std::vector<std::uint32_t>> object;
  std::vector<std::size_t> points;  ///< per object, in the segmentation that it comes from
};

/// Matches segmentations of the same points. The first one's segments are the objects; each further
/// one's are matched with them one to one, by overlap |A n B| / |A u B| (eq. (11)), the largest
/// first; those that overlap none by at least `least` are objects of their own from there on.
/// \param labels one entry a segmentation, each one label a point.
MatchedLabels match_labels(const std::vector<std::span<const std::uint32_t>>& labels,
                           double least = 0.05);

/// Colours of the objects: calm ones for those that lie on planes, vivid ones for others;
/// neighbours are kept apart, and so are the 16 largest, wherever they are: a colour means an
/// object.
std::vector<Pixel> color_objects(const MatchedLabels& matched, const std::vector<bool>& on_plane,
                                 const Neighbours& neighbours);

/// Which objects lie on planes: by more than half of the points that they have in the first
/// segmentation that has them. Where no point has a plane: those of at least a tenth of the points.
/// \param point_plane per point: plane, or kNone.
std::vector<bool> objects_on_planes(const std::vector<std::span<const std::uint32_t>>& labels,
                                    const MatchedLabels& matched,
                                    std::span<const std::int32_t> point_plane);

/// Pairs of objects that touch in some segmentation: those of patches that are adjacent.
/// \param point_patch per point: patch, or kNone; \param edges pairs of patches.
Neighbours touching_objects(const std::vector<std::span<const std::uint32_t>>& labels,
                            const MatchedLabels& matched, std::span<const std::int32_t> point_patch,
                            std::size_t patches, const Neighbours& edges);

}  // namespace planescope::draw
