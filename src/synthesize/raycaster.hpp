// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "synthesize/scene.hpp"

namespace planescope::synthesis {

/// Where a ray first meets the scene.
struct Hit {
  double t = kNoHit;
  std::int32_t surface = kNone;
};

/// Finds what a ray meets first, exactly, by a hierarchy of boxes around the surfaces. Surfaces are
/// seen from their outer side only. Keeps a reference to the scene.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);

  /// Of surfaces at the same distance, the lowest index.
  Hit cast(const Ray& ray) const;

  const Scene& scene() const { return scene_; }

 private:
  struct Node {
    Box3d box;
    std::uint32_t first = 0, count = 0;  // of order_, in a leaf
    std::uint32_t right = 0;  // second child of an inner node (the first one is next); leaf: 0
  };

  void meet(const Node& leaf, const Ray& ray, Hit& hit) const;
  void build(std::uint32_t first, std::uint32_t count, const std::vector<Box3d>& boxes);

  const Scene& scene_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace planescope::synthesis
