// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "synthesize/raycaster.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>

namespace planescope::synthesis {
namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr std::size_t kMaxDepth = 256;  // a child has at most 7/8 of the surfaces: 100,000 of them
                                        // need 87 levels

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

double area_of(const Box3d& box) {
  const Vector3d size = box.sizes();
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

// Sorts the surfaces along an axis, and finds where to split them so that a ray has least to do:
// the surface area heuristic (Goldsmith and Salmon 1987). \returns its cost and the left count.
std::pair<double, std::uint32_t> sweep(std::span<std::uint32_t> order, int axis,
                                       const std::vector<Box3d>& boxes) {
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(boxes[a].center()[axis], a) < std::pair(boxes[b].center()[axis], b);
  });
  std::vector<double> right_area(order.size());
  Box3d box;
  for (std::size_t i = order.size(); i-- > 1;) {
    box.extend(boxes[order[i]]);
    right_area[i] = area_of(box);
  }
  std::pair<double, std::uint32_t> best{kNoHit, 0};
  box.setEmpty();
  for (std::size_t i = 1; i < order.size(); ++i) {
    box.extend(boxes[order[i - 1]]);
    const double cost = area_of(box) * static_cast<double>(i) +
                        right_area[i] * static_cast<double>(order.size() - i);
    best = std::min(best, {cost, static_cast<std::uint32_t>(i)});
  }
  return best;
}

// Sorts the surfaces so that the first of them, as many as it returns, are one half of the split.
std::uint32_t split(std::span<std::uint32_t> order, const std::vector<Box3d>& boxes) {
  int best_axis = 0;
  std::pair<double, std::uint32_t> best{kNoHit, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto found = sweep(order, axis, boxes);
    if (found.first >= best.first) continue;
    best = found;
    best_axis = axis;
  }
  sweep(order, best_axis, boxes);
  // A lopsided tree could outgrow the stack of cast().
  const auto count = static_cast<std::uint32_t>(order.size());
  return std::clamp(best.second, std::max(1u, count / 8), count - std::max(1u, count / 8));
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
  const std::uint32_t left = split(std::span(order_).subspan(first, count), boxes);
  build(first, left, boxes);
  nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
  build(first + left, count - left, boxes);
}

Hit RayCaster::cast(const Ray& ray) const {
  const Vector3d inverse = ray.direction.cwiseInverse();
  std::array<std::pair<double, std::uint32_t>, kMaxDepth> stack;  // where a node is entered
  std::size_t top = 0;
  Hit hit;
  const auto push = [&](std::uint32_t node, double t) {
    if (t < kNoHit) stack[top++] = {t, node};
  };
  push(0, enter(nodes_[0].box, ray, inverse));
  while (top > 0) {
    const auto [t, index] = stack[--top];
    if (t > hit.t) continue;
    const Node& node = nodes_[index];
    if (node.right == 0) {
      meet(node, ray, hit);
      continue;
    }
    const double left = enter(nodes_[index + 1].box, ray, inverse);
    const double right = enter(nodes_[node.right].box, ray, inverse);
    if (left <= right) {  // the nearer one is pushed last, and looked at first
      push(node.right, right);
      push(index + 1, left);
    } else {
      push(index + 1, left);
      push(node.right, right);
    }
  }
  return hit;
}

void RayCaster::meet(const Node& leaf, const Ray& ray, Hit& hit) const {
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
    const auto surface = static_cast<std::int32_t>(order_[i]);
    const double t = scene_.surfaces()[order_[i]].geometry.intersect(ray);
    if (t < hit.t || (t == hit.t && t < kNoHit && surface < hit.surface)) hit = {t, surface};
  }
}

}  // namespace planescope::synthesis
