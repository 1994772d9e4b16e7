// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "planescope/explain.hpp"
#include "planescope/explain_planes.hpp"

/// \file Numbers and findings as people read them.
namespace planescope {

std::string number(double value, int digits = 3);
/// `1 edge`, `2 edges`
std::string counted(std::size_t count, const std::string& what);
/// `12.3 mm`, `1.25 m`
std::string length_words(double metres);
/// A value with its unit; metres as length_words().
std::string with_unit(double value, const std::string& unit);
/// `(0.120, -1.500, 2.000)`
std::string place_words(const Eigen::Vector3f& p);
/// `edges.concavity_tolerance 14 (now 10)`
std::string settings_words(const std::vector<Setting>& settings);
/// What a change does to the scene: `in all 3 edges go ON, ...`
std::string effect_words(const Flip& flip);
/// Settings, the rule then, and the effect.
std::string flip_words(const Flip& flip);
std::string patch_words(const PatchReport& report);
std::string measure_words(const Measure& measure);
std::string hypothesis_words(const PlaneHypothesis& hypothesis, double lambda);
/// What a hypothesis costs in all: of a face but for its overlap with other faces.
std::string cost_words(const PlaneHypothesis& hypothesis, PlaneRole role);
/// What a plane has for itself: as a hypothesis, or as a face.
std::string chosen_words(const PlaneExplanation& explanation);
std::string pair_words(const PairCost& pair);
/// The numbers of its patches, each after a space.
std::string patches_words(const Chain& chain);
std::string plane_words(const Plane& plane);

}  // namespace planescope
