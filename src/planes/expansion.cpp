// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "planes/labelling.hpp"
#include "planes/max_flow.hpp"

namespace planescope {
namespace {

/// One labelling that expansions improve, with what they reuse from move to move. A move is a graph
/// of only the patches that may take the label and do not have it, so that the moves of all planes
/// together cost about as much as one pass over the patches.
class Expansion {
 public:
  Expansion(const LabellingProblem& problem, Labels labels)
      : problem_(problem), labels_(std::move(labels)), node_(problem.size(), kNoNode) {
    current_.assign(problem.size(), problem.none_cost);
    for (std::size_t p = 0; p < problem.labels(); ++p) {
      for (const Choice& member : problem.members_of(p)) {
        if (labels_[member.index] == static_cast<std::int32_t>(p)) {
          current_[member.index] = member.cost;
        }
      }
    }
  }

  /// The best expansion of `alpha`; true if a patch changed. Of moves with equal energy the one
  /// with fewest changes is made, so that a change always lowers E.
  bool move(std::int32_t alpha) {
    collect(alpha);
    flow_.reset(movable_.size());
    for (std::uint32_t node = 0; node < movable_.size(); ++node) connect(node, alpha);
    flow_.solve();
    bool changed = false;
    for (std::uint32_t node = 0; node < movable_.size(); ++node) {
      const Choice& choice = movable_[node];
      node_[choice.index] = kNoNode;
      if (!flow_.on_source_side(node)) continue;
      labels_[choice.index] = alpha;
      current_[choice.index] = choice.cost;
      changed = true;
    }
    return changed;
  }

  Labels take() { return std::move(labels_); }

 private:
  static constexpr std::uint32_t kNoNode = 0xffffffffu;

  /// The patches that may change to `alpha`.
  void collect(std::int32_t alpha) {
    movable_.clear();
    const auto add = [&](std::uint32_t patch, std::int32_t cost) {
      if (labels_[patch] == alpha) return;
      node_[patch] = static_cast<std::uint32_t>(movable_.size());
      movable_.push_back({patch, cost});
    };
    if (alpha == kNone) {
      for (std::uint32_t i = 0; i < problem_.size(); ++i) add(i, problem_.none_cost);
    } else {
      for (const Choice& member : problem_.members_of(static_cast<std::size_t>(alpha))) {
        add(member.index, member.cost);
      }
    }
  }

  /// Costs of a node: on the source side it takes alpha and its link to the sink is cut, on the
  /// sink side it stays. Two nodes i, j of different labels cost w unless both take alpha (x = 1):
  /// w - w x_i x_j = w - w x_j + w (1 - x_i) x_j, a terminal cost and one arc j -> i.
  void connect(std::uint32_t node, std::int32_t alpha) {
    const std::uint32_t i = movable_[node].index;
    const std::int32_t w = problem_.potts;
    MaxFlow::Flow stay = current_[i], take = movable_[node].cost;
    for (const std::uint32_t j : problem_.neighbours_of(i)) {
      const std::uint32_t other = node_[j];
      if (other == kNoNode) {
        (labels_[j] == alpha ? stay : take) += w;
        if (labels_[j] != alpha && labels_[j] != labels_[i]) stay += w;
      } else if (other > node) {
        continue;  // the edge is made from its second node
      } else if (labels_[j] == labels_[i]) {
        flow_.add_edge(other, node, w, w);
      } else {
        stay += w;
        flow_.add_edge(node, other, w, 0);
      }
    }
    flow_.add_terminal(node, stay, take);
  }

  const LabellingProblem& problem_;
  Labels labels_;
  std::vector<std::int32_t> current_;  ///< U of each patch's label
  std::vector<Choice> movable_;        ///< the nodes of a move, with their U of alpha
  std::vector<std::uint32_t> node_;    ///< per patch: its node, or kNoNode
  MaxFlow flow_;
};

}  // namespace

Labels expand_labels(const LabellingProblem& problem, Labels labels) {
  Expansion expansion(problem, std::move(labels));
  const std::size_t moves = problem.labels() + 1;  // the planes, then "no plane"
  std::size_t idle = 0;  // moves since the last that changed something; all idle: a minimum
  for (std::size_t k = 0; idle < moves; k = (k + 1) % moves) {
    const std::int32_t alpha = k + 1 == moves ? kNone : static_cast<std::int32_t>(k);
    idle = expansion.move(alpha) ? 1 : idle + 1;  // a label's own best expansion is done
  }
  return expansion.take();
}

}  // namespace planescope
