// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planescope/cloud.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/synthesize.hpp"

/// \file The method with one part taken away at a time.
namespace planescope::bench {

/// A cloud with all that its variants share.
struct AblationScene {
  std::string name;
  PointCloud cloud;               ///< with labels
  std::vector<TruePlane> planes;  ///< empty: not known
  bool is_tabletop = false;
  Options options;     ///< of `auto`
  PointCloud surface;  ///< what patches are made of
  PatchGraph graph;    ///< patches of `options`
};

/// The scene of a cloud: its options and patches.
AblationScene prepare(std::string name, PointCloud cloud, std::vector<TruePlane> planes);

/// Parts that no option switches.
struct Parts {
  bool printed_data_cost = false;   ///< D of eq. (4) as printed, above 0 for every plane
  bool printed_assignment = false;  ///< eq. (10) as printed: neighbours pay for equal labels (ICM)
  bool refit = true;                ///< of supporting planes after the assignment
  bool shared_directions = true;    ///< of planes and faces
  bool border_points = true;        ///< borders between segments are cut point by point
  bool fixed_preset = false;        ///< `tabletop` or `room` instead of `auto`
};

/// One row of the table.
struct Variant {
  std::string name;
  std::vector<std::pair<std::string, std::string>> settings = {};  ///< options by name
  Parts parts = {};
};

/// The full method first, then what is taken away.
const std::vector<Variant>& variants();

/// Segments the scene by that variant.
Segmentation run(const AblationScene& scene, const Variant& variant);

}  // namespace planescope::bench
