// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_node.hpp"

/// \file Options and hypotheses of a stored result: what asking why goes by.
namespace planescope {
namespace {

/// An index below `count`.
std::uint32_t index_below(const Node& node, std::size_t count) {
  if (count == 0) node.fail("no index: there is no hypothesis");
  return node.count(static_cast<std::uint32_t>(count - 1));
}

/// What accepted and refused hypotheses have in common. \returns its index.
std::uint32_t read_hypothesis(const Node& node, PlaneSelection& selection) {
  const std::uint32_t index = index_below(node["hypothesis"], selection.hypotheses.size());
  PlaneHypothesis& h = selection.hypotheses[index];
  h.plane = {node["normal"].unit(), node["distance"].real()};
  h.inlier_count = node["inliers"].count();
  h.inlier_area = node["area"].real();
  h.data_cost = node["data_cost"].number();
  h.flip_cost = node["flip_cost"].number();
  return index;
}

}  // namespace

Options read_options(const Node& node) {
  Options options;
  for (const auto& [name, value] : node.members()) {
    try {
      set_option(options, name, value.is_text() ? value.text() : value.dump());
    } catch (const Error& error) {
      value.fail(std::string("an option (") + error.what() + ")");
    }
  }
  return options;
}

PlaneSelection read_selection(const Node& node) {
  constexpr std::uint32_t kMost = 1'000'000;  // of a file that is not believed
  PlaneSelection selection;
  selection.proposed = node["proposed"].count();
  selection.lambda = node["lambda"].number();
  selection.energy = node["energy"].number();
  selection.hypotheses.resize(node["entered"].count(kMost));
  for (const Node& one : node["accepted"].items()) {
    const std::uint32_t index = read_hypothesis(one, selection);
    if (!selection.selected.empty() && index <= selection.selected.back())
      one["hypothesis"].fail("more than the one before");
    selection.hypotheses[index].selected = true;
    selection.selected.push_back(index);
  }
  for (const Node& one : node["rejected"].items()) {
    PlaneHypothesis& h = selection.hypotheses[read_hypothesis(one, selection)];
    if (h.selected) one["hypothesis"].fail("one that was not accepted");
    const Node by = one["blocked_by"];
    if (!by.null())
      h.blocked_by = static_cast<std::int32_t>(index_below(by, selection.hypotheses.size()));
    h.blocked_angle_cost = one["angle_cost"].number();
    h.blocked_overlap_cost = one["overlap_cost"].number();
  }
  return selection;
}

}  // namespace planescope
