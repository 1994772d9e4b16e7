// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "planescope/result.hpp"
#include "viewpoint.hpp"

/// \file What a picture must hold.
namespace planescope::draw {

/// A sample of the points that a picture is fitted to: finite, in a segment (all, if there is
/// none), not cut away, and no strays. Laser scans look out of windows: where the outermost 0.5,
/// 2 or 5 % of the points along one of the scene's axes take up 10, 20 or 30 % of its extent, they
/// are strays; a room's wall holds more points than that, and stays.
/// \throws Error{Kind::Input} no point is finite.
std::vector<Eigen::Vector3f> points_to_fit(const Result& result, const SceneFrame& frame,
                                           const Cutaway& cut);

}  // namespace planescope::draw
