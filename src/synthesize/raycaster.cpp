// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/raycaster.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace planescope::synthesis {
namespace {

constexpr std::uint32_t kLeaf = 4;

// Where the ray enters the box, or kNoHit. A division by zero gives an infinity of the right sign,
// and a ray within a face's plane (0 * infinity) is let through by the order of min and max.
double enter(const Box3d& box, const Ray& ray, const Vector3d& inverse) {
  double t0 = 0, t1 = kNoHit;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - ray.origin[axis]) * inverse[axis];
    const double b = (box.max()[axis] - ray.origin[axis]) * inverse[axis];
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1 * (1 + 1e-12) ? t0 : kNoHit;
}

}  // namespace

RayCaster::RayCaster(const Scene& scene) : scene_(scene), order_(scene.surfaces().size()) {
  std::vector<Box3d> boxes;
  boxes.reserve(order_.size());
  for (const Surface& surface : scene.surfaces()) {
    // Planes have flat boxes; a little thickness keeps rounding from missing them.
    const Box3d flat = surface.geometry.bounds();
    const Vector3d skin = Vector3d::Constant(1e-6);
    boxes.emplace_back(flat.min() - skin, flat.max() + skin);
  }
  std::iota(order_.begin(), order_.end(), 0u);
  build(0, static_cast<std::uint32_t>(order_.size()), boxes);
}

void RayCaster::build(std::uint32_t first, std::uint32_t count, const std::vector<Box3d>& boxes) {
  const std::size_t self = nodes_.size();
  nodes_.emplace_back();
  for (std::uint32_t i = first; i < first + count; ++i) nodes_[self].box.extend(boxes[order_[i]]);
  if (count <= kLeaf) {
    nodes_[self].first = first;
    nodes_[self].count = count;
    return;
  }
  Eigen::Index axis = 0;
  nodes_[self].box.sizes().maxCoeff(&axis);
  const auto begin = order_.begin() + first;
  std::stable_sort(begin, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].center()[axis] < boxes[b].center()[axis];
  });
  build(first, count / 2, boxes);
  nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
  build(first + count / 2, count - count / 2, boxes);
}

Hit RayCaster::cast(const Ray& ray) const {
  const Vector3d inverse = ray.direction.cwiseInverse();
  std::array<std::uint32_t, 64> stack;  // halving: the depth is log2 of the number of surfaces
  std::size_t top = 0;
  stack[top++] = 0;
  Hit hit;
  while (top > 0) {
    const std::uint32_t index = stack[--top];
    const Node& node = nodes_[index];
    if (enter(node.box, ray, inverse) > hit.t) continue;
    if (node.right != 0) {
      stack[top++] = node.right;
      stack[top++] = index + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const auto surface = static_cast<std::int32_t>(order_[i]);
      const double t = scene_.surfaces()[order_[i]].geometry.intersect(ray);
      if (t < hit.t || (t == hit.t && t < kNoHit && surface < hit.surface)) hit = {t, surface};
    }
  }
  return hit;
}

}  // namespace planescope::synthesis
