// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "planescope/synthesize.hpp"

/// \file What the tests of synthesized scenes share.
namespace planescope::testing {

inline SynthesisOptions evenly(std::uint64_t seed, std::uint64_t points) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.points = points;
  return options;
}

inline SynthesisOptions seen(std::uint64_t seed, std::uint32_t views) {
  SynthesisOptions options;
  options.random_seed = seed;
  options.views = views;
  return options;
}

// `chair 3` -> `chair`.
inline std::string kind_of(const std::string& object) { return object.substr(0, object.find(' ')); }

inline bool is_round(const std::string& object) {
  return std::set<std::string>{"ball", "bin", "cup", "lamp"}.contains(kind_of(object));
}

inline std::map<std::uint32_t, std::vector<const TruePlane*>> planes_by_label(
    const SynthesizedScene& scene) {
  std::map<std::uint32_t, std::vector<const TruePlane*>> planes;
  for (const TruePlane& plane : scene.planes) planes[plane.label].push_back(&plane);
  return planes;
}

inline float nearest_plane(const Eigen::Vector3f& p, const std::vector<const TruePlane*>& planes) {
  float nearest = std::numeric_limits<float>::infinity();
  for (const TruePlane* plane : planes) {
    nearest = std::min(nearest, std::abs(plane->plane.signed_distance(p)));
  }
  return nearest;
}

}  // namespace planescope::testing
