// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "io/input_file.hpp"
#include "io/point_fields.hpp"
#include "io/point_source.hpp"
#include "planescope/cloud.hpp"

/// \file From the numbers of a file to a PointCloud, the same way for every format.
namespace planescope::io {

/// What a header says beyond the fields.
struct Frame {
  std::size_t points = 0;                    ///< at least 1
  std::uint32_t width = 0, height = 1;       ///< width * height == points
  std::optional<Eigen::Vector3d> viewpoint;  ///< [m] PCD's VIEWPOINT translation; none in PLY
};

/// A cloud, and the extra columns that were selected, one number a point.
struct Assembled {
  PointCloud cloud;
  std::vector<std::vector<std::int32_t>> extra;
};

/// The shift of a cloud: zero where the cloud lies within 1 km of the file's origin along each
/// axis, else the whole metres nearest to where it lies. "Where it lies" is the component-wise
/// median of a fixed sample (64 groups of 16 neighbours, evenly spaced in the file), so that no
/// outlier, however far, moves it: the centre of a bounding box would cost all other points their
/// precision.
Eigen::Vector3d choose_origin(const PointSource& source, const Selection& selection,
                              std::size_t points);

/// Decodes all points, in parallel blocks that each write their own part. `origin`: the shift, or
/// nothing for choose_origin(). Normals that are not of unit length are normalised; those without
/// length are unknown. The sensor is the viewpoint where that is not (0,0,0), which every PCD file
/// has that knows no better; for an organised cloud that is not shifted (0,0,0) counts too: it is
/// the camera's own frame.
/// \throws Error{Kind::Input} no finite point; a label or extra number out of range; reading fails.
Assembled assemble(const InputFile& file, const PointSource& source, const Selection& selection,
                   const Frame& frame, const std::optional<Eigen::Vector3d>& origin = {});

}  // namespace planescope::io
