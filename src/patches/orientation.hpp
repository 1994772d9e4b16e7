// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include <Eigen/Core>

#include "planescope/patches.hpp"

namespace planescope {

/// Turns each patch's normal towards the sensor.
void orient_towards(std::vector<Patch>& patches, const Eigen::Vector3f& sensor);

/// Turns each patch's normal to the side of `votes[i]`, the sum of its points' given normals; where
/// that is zero the normal stays.
void orient_by_votes(std::vector<Patch>& patches, const std::vector<Eigen::Vector3f>& votes);

/// Makes the normals of adjacent patches agree where no sensor is known, because convexity flips
/// with them: along a spanning tree of the surest pairs (Hoppe et al., SIGGRAPH 1992), where two
/// patches agree if the normal of one, mirrored in the plane between the centroids, points as the
/// other's does (Koenig and Gumhold, VMV 2009): right at sharp corners too. Each connected piece is
/// then turned as a whole: towards the scene's middle by the majority of its area.
void orient_consistently(PatchGraph& graph);

}  // namespace planescope
