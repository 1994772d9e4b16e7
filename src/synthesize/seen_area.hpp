// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "planescope/cloud.hpp"
#include "synthesize/camera.hpp"

namespace planescope::synthesis {

/// How much of each planar surface depth cameras have seen so far, in cells of about 5 cm: views
/// overlap, so that areas of pixels must not be added up. Keeps a reference to the scene.
class SeenArea {
 public:
  explicit SeenArea(const Scene& scene);

  /// Marks what the finite points of a view show.
  void add(const Camera& camera, const DepthView& view, const PointCloud& cloud);

  /// Area and centroid of what was seen of a surface; area 0 if nothing, or if it is not planar.
  VisiblePart part(std::size_t surface) const;

 private:
  struct Grid {
    int columns = 0, rows = 0;
    std::vector<bool> seen;
  };

  const Scene& scene_;
  std::vector<Grid> grids_;  ///< per surface; empty where it is not planar
};

}  // namespace planescope::synthesis
