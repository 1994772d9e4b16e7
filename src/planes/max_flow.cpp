// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/max_flow.hpp"

#include <algorithm>
#include <limits>

namespace planescope {
namespace {

constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();

}  // namespace

void MaxFlow::reset(std::size_t nodes) {
  nodes_.assign(nodes, NodeState());
  edges_.clear();
  queue_.clear();
  orphans_.clear();
  queue_head_ = 0;
  time_ = 0;
  flow_ = 0;
}

void MaxFlow::add_terminal(Node node, Flow from_source, Flow to_sink) {
  Flow& excess = nodes_[node].excess;  // what passes through the node at once is flow already
  const Flow source = from_source + std::max<Flow>(excess, 0);
  const Flow sink = to_sink + std::max<Flow>(-excess, 0);
  flow_ += std::min(source, sink);
  excess = source - sink;
}

void MaxFlow::add_edge(Node a, Node b, Capacity forward, Capacity backward) {
  edges_.push_back({a, b, forward, backward});
}

void MaxFlow::build_arcs() {
  first_arc_.assign(nodes_.size() + 1, 0);
  for (const Edge& edge : edges_) ++first_arc_[edge.a + 1], ++first_arc_[edge.b + 1];
  for (std::size_t i = 0; i < nodes_.size(); ++i) first_arc_[i + 1] += first_arc_[i];
  arcs_.resize(2 * edges_.size());
  std::vector<Arc> next(first_arc_.begin(), first_arc_.end() - 1);
  for (const Edge& edge : edges_) {
    const Arc there = next[edge.a]++, back = next[edge.b]++;
    arcs_[there] = {edge.b, back, edge.forward};
    arcs_[back] = {edge.a, there, edge.backward};
  }
}

void MaxFlow::activate(Node node) {
  if (nodes_[node].active) return;
  nodes_[node].active = true;
  queue_.push_back(node);
}

void MaxFlow::plant_trees() {
  for (Node i = 0; i < nodes_.size(); ++i) {
    NodeState& node = nodes_[i];
    if (node.excess == 0) continue;
    node.tree = node.excess > 0 ? Tree::Source : Tree::Sink;
    node.parent = kTerminal;
    node.distance = 1;
    activate(i);
  }
}

MaxFlow::Flow MaxFlow::solve() {
  build_arcs();
  plant_trees();
  while (queue_head_ < queue_.size()) {
    const Node node = queue_[queue_head_];
    const Arc bridge = nodes_[node].tree == Tree::None ? kNoArc : grow(node);
    if (bridge == kNoArc) {
      nodes_[node].active = false;
      ++queue_head_;
      continue;
    }
    ++time_;  // the node stays at the head: it may touch the other tree again
    augment(bridge);
    adopt_orphans();
  }
  return flow_;
}

/// Takes all free neighbours into the node's tree. Returns the first arc, source tree to sink tree,
/// that joins the trees, or kNoArc.
MaxFlow::Arc MaxFlow::grow(Node i) {
  const NodeState& node = nodes_[i];
  for (Arc arc = first_arc_[i]; arc < first_arc_[i + 1]; ++arc) {
    if (outward(node.tree, arc) == 0) continue;
    NodeState& other = nodes_[arcs_[arc].head];
    if (other.tree == Tree::None) {
      other.tree = node.tree;
      other.parent = arcs_[arc].sister;
      other.time = node.time;
      other.distance = node.distance + 1;
      activate(arcs_[arc].head);
    } else if (other.tree != node.tree) {
      return node.tree == Tree::Source ? arc : arcs_[arc].sister;
    } else if (other.time <= node.time && other.distance > node.distance + 1) {
      other.parent = arcs_[arc].sister;  // a shorter way to the terminal
      other.time = node.time;
      other.distance = node.distance + 1;
    }
  }
  return kNoArc;
}

MaxFlow::Flow MaxFlow::bottleneck(Arc bridge) const {
  Flow least = arcs_[bridge].residual;
  Node i = arcs_[arcs_[bridge].sister].head;
  for (; nodes_[i].parent != kTerminal; i = arcs_[nodes_[i].parent].head) {
    least = std::min<Flow>(least, arcs_[arcs_[nodes_[i].parent].sister].residual);
  }
  least = std::min(least, nodes_[i].excess);
  for (i = arcs_[bridge].head; nodes_[i].parent != kTerminal; i = arcs_[nodes_[i].parent].head) {
    least = std::min<Flow>(least, arcs_[nodes_[i].parent].residual);
  }
  return std::min(least, -nodes_[i].excess);
}

void MaxFlow::make_orphan(Node node) {
  nodes_[node].parent = kOrphan;
  orphans_.push_back(node);
}

/// Sends flow along the tree path between a node and its terminal; a node whose arc to the parent
/// is then full becomes an orphan.
void MaxFlow::push_to_terminal(Node i, Flow flow, Tree tree) {
  const auto amount = static_cast<Capacity>(flow);
  while (nodes_[i].parent != kTerminal) {
    const Arc up = nodes_[i].parent;
    const Arc with = tree == Tree::Source ? arcs_[up].sister : up;  // the flow's own direction
    arcs_[with].residual -= amount;
    arcs_[arcs_[with].sister].residual += amount;
    const Node parent = arcs_[up].head;
    if (arcs_[with].residual == 0) make_orphan(i);
    i = parent;
  }
  nodes_[i].excess += tree == Tree::Source ? -flow : flow;
  if (nodes_[i].excess == 0) make_orphan(i);
}

void MaxFlow::augment(Arc bridge) {
  const Flow flow = bottleneck(bridge);
  const Arc sister = arcs_[bridge].sister;
  arcs_[bridge].residual -= static_cast<Capacity>(flow);
  arcs_[sister].residual += static_cast<Capacity>(flow);
  push_to_terminal(arcs_[sister].head, flow, Tree::Source);
  push_to_terminal(arcs_[bridge].head, flow, Tree::Sink);
  flow_ += flow;
}

void MaxFlow::adopt_orphans() {
  for (std::size_t k = 0; k < orphans_.size(); ++k) adopt(orphans_[k]);
  orphans_.clear();
}

void MaxFlow::adopt(Node orphan) {
  std::uint32_t distance = kFar;
  const Arc parent = nearest_parent(orphan, distance);
  if (parent == kNoArc) {
    release(orphan);
    return;
  }
  nodes_[orphan].parent = parent;
  nodes_[orphan].time = time_;
  nodes_[orphan].distance = distance + 1;
}

/// The arc to the neighbour in the orphan's tree that is nearest to the terminal and can pass flow.
MaxFlow::Arc MaxFlow::nearest_parent(Node orphan, std::uint32_t& distance) {
  const Tree tree = nodes_[orphan].tree;
  Arc best = kNoArc;
  for (Arc arc = first_arc_[orphan]; arc < first_arc_[orphan + 1]; ++arc) {
    const Node other = arcs_[arc].head;
    if (nodes_[other].tree != tree || outward(tree, arcs_[arc].sister) == 0) continue;
    const std::uint32_t d = origin_distance(other);
    if (d < distance) best = arc, distance = d;
  }
  return best;
}

/// Arcs from the node to its terminal, or kFar if the path ends at an orphan. Marks the path with
/// the present time, so that later walks stop where they meet it.
std::uint32_t MaxFlow::origin_distance(Node node) {
  std::uint32_t steps = 0;
  Node i = node;
  for (; nodes_[i].time != time_; i = arcs_[nodes_[i].parent].head) {
    if (nodes_[i].parent == kOrphan) return kFar;
    if (nodes_[i].parent == kTerminal) {
      nodes_[i].time = time_;
      nodes_[i].distance = 1;
      break;
    }
    ++steps;
  }
  if (nodes_[i].parent == kOrphan) return kFar;
  const std::uint32_t distance = nodes_[i].distance + steps;
  std::uint32_t d = distance;
  for (Node j = node; j != i; j = arcs_[nodes_[j].parent].head) {
    nodes_[j].time = time_;
    nodes_[j].distance = d--;
  }
  return distance;
}

/// The orphan leaves its tree, its children become orphans, and whoever could take it back grows.
void MaxFlow::release(Node orphan) {
  const Tree tree = nodes_[orphan].tree;
  for (Arc arc = first_arc_[orphan]; arc < first_arc_[orphan + 1]; ++arc) {
    const Node other = arcs_[arc].head;
    if (nodes_[other].tree != tree) continue;
    if (outward(tree, arcs_[arc].sister) != 0) activate(other);
    if (nodes_[other].parent == arcs_[arc].sister) make_orphan(other);
  }
  nodes_[orphan].tree = Tree::None;
  nodes_[orphan].parent = kNoArc;
}

}  // namespace planescope
