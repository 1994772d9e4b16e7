// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image.hpp"
#include "planescope/graph_picture.hpp"
#include "scene_data.hpp"

/// \file Kinds of edges as a picture tells them apart.
namespace planescope::draw {

/// One kind: a line of the legend.
struct EdgeClass {
  std::string key;   ///< in JSON
  std::string name;  ///< in the legend
  Pixel color{};
  double width = 1;  ///< over a thin line: what is sought is thicker, in print without colours too
  std::size_t count = 0;
};

/// The kinds, and which one each edge is.
struct EdgeClasses {
  static constexpr std::uint8_t kHidden = 255;  ///< does not pass the filter
  std::vector<EdgeClass> kinds;
  std::vector<std::uint8_t> of;  ///< one entry an edge of the graph
};

/// \param patch_truth labels of patch_truth(), for EdgeColor::Truth.
EdgeClasses classify(const SceneData& scene, const GraphOptions& options,
                     const std::vector<std::uint32_t>& patch_truth);

}  // namespace planescope::draw
