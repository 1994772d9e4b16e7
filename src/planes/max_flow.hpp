// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// \file Minimum s-t cuts.
namespace planescope {

/// Maximum flow by two search trees that are kept from one augmentation to the next (Boykov and
/// Kolmogorov, "An Experimental Comparison of Min-Cut/Max-Flow Algorithms for Energy Minimization
/// in Vision", PAMI 2004, Section 3), with the distance and time marks of Kolmogorov's thesis
/// (2004) that find an orphan's nearest origin without walking each path twice. Written from those
/// texts. Capacities are integers, so that the answer is exact and the same everywhere.
///
/// Use: reset(), add_terminal() and add_edge() in any order, solve() once, on_source_side().
class MaxFlow {
 public:
  using Node = std::uint32_t;
  using Capacity = std::int32_t;
  using Flow = std::int64_t;

  /// Forgets everything; nodes 0 .. nodes - 1 without edges. Memory is kept for reuse.
  void reset(std::size_t nodes);

  /// Adds capacity source -> node and node -> sink; each at least 0.
  void add_terminal(Node node, Flow from_source, Flow to_sink);

  /// Adds an edge with capacity a -> b and b -> a; each at least 0, a != b.
  void add_edge(Node a, Node b, Capacity forward, Capacity backward);

  /// The value of the maximum flow, which is that of the minimum cut.
  Flow solve();

  /// After solve(): true if the node is reachable from the source in the residual graph. These
  /// nodes are the smallest source side of all minimum cuts.
  bool on_source_side(Node node) const { return nodes_[node].tree == Tree::Source; }

 private:
  using Arc = std::uint32_t;
  enum class Tree : std::uint8_t { None, Source, Sink };
  static constexpr Arc kNoArc = 0xffffffffu;     ///< in no tree
  static constexpr Arc kTerminal = 0xfffffffeu;  ///< child of the terminal itself
  static constexpr Arc kOrphan = 0xfffffffdu;    ///< waits for a new parent

  struct NodeState {
    Flow excess = 0;             ///< residual capacity from the source, or, negative, to the sink
    Arc parent = kNoArc;         ///< arc from this node to its parent in the tree
    std::uint32_t time = 0;      ///< when `distance` was known to be right
    std::uint32_t distance = 0;  ///< arcs to the terminal along parents
    Tree tree = Tree::None;
    bool active = false;  ///< in the queue of nodes that may grow
  };
  struct ArcState {
    Node head = 0;
    Arc sister = 0;  ///< the same edge the other way
    Capacity residual = 0;
  };
  struct Edge {
    Node a, b;
    Capacity forward, backward;
  };

  void build_arcs();
  void plant_trees();
  Arc grow(Node node);
  void augment(Arc bridge);
  Flow bottleneck(Arc bridge) const;
  void push_to_terminal(Node node, Flow flow, Tree tree);
  void adopt_orphans();
  void adopt(Node orphan);
  Arc nearest_parent(Node orphan, std::uint32_t& distance);
  std::uint32_t origin_distance(Node node);
  void release(Node orphan);
  void activate(Node node);
  void make_orphan(Node node);
  /// Residual capacity along the tree's direction of an arc that leaves a node of that tree.
  Capacity outward(Tree tree, Arc arc) const {
    return arcs_[tree == Tree::Source ? arc : arcs_[arc].sister].residual;
  }

  std::vector<NodeState> nodes_;
  std::vector<Edge> edges_;
  std::vector<Arc> first_arc_;  ///< of each node; arcs of node i are first_arc_[i] .. [i + 1] - 1
  std::vector<ArcState> arcs_;
  std::vector<Node> queue_, orphans_;
  std::size_t queue_head_ = 0;
  std::uint32_t time_ = 0;
  Flow flow_ = 0;
};

}  // namespace planescope
