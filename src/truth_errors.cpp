// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/truth_errors.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "planescope/error.hpp"
#include "planescope/explain.hpp"

namespace planescope {
namespace {

using Counts = std::map<std::uint32_t, std::uint64_t>;

/// The label of most points; of equals the lowest. (0, 0) of none.
std::pair<std::uint32_t, std::uint64_t> most(const Counts& counts) {
  std::pair<std::uint32_t, std::uint64_t> best{0, 0};
  for (const auto& [label, points] : counts)
    if (points > best.second) best = {label, points};
  return best;
}

void check_lengths(std::size_t points, std::size_t truth) {
  if (points == truth) return;
  throw Error(Error::Kind::Input, "truth: has " + std::to_string(truth) +
                                      " points, the scene has " + std::to_string(points) +
                                      "; name the cloud that the scene was made from");
}

}  // namespace

std::vector<std::uint32_t> object_labels(std::vector<std::uint32_t> labels, std::uint32_t divide) {
  if (divide == 0) throw Error(Error::Kind::Usage, "truth labels are divided by 0; expected 1 up");
  for (std::uint32_t& label : labels)
    if (label != 0) label = std::max(1u, label / divide * divide);
  return labels;
}

std::vector<std::uint32_t> patch_truth(std::span<const std::int32_t> point_patch,
                                       std::span<const std::uint32_t> truth,
                                       std::size_t patch_count, double purity) {
  check_lengths(point_patch.size(), truth.size());
  std::vector<Counts> counts(patch_count);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (point_patch[i] != kNone && truth[i] != 0)
      ++counts[static_cast<std::size_t>(point_patch[i])][truth[i]];
  }
  std::vector<std::uint32_t> labels(patch_count, 0);
  for (std::size_t p = 0; p < patch_count; ++p) {
    std::uint64_t all = 0;
    for (const auto& [label, points] : counts[p]) all += points;
    const auto [label, points] = most(counts[p]);
    if (static_cast<double>(points) >= purity * static_cast<double>(all)) labels[p] = label;
  }
  return labels;
}

std::string_view name(EdgeError error) {
  constexpr std::array<std::string_view, kEdgeErrorCount> kNames = {"right", "merged", "cut",
                                                                    "unjudged"};
  return kNames[static_cast<std::size_t>(error)];
}

std::string_view name(PointError error) {
  constexpr std::array<std::string_view, kPointErrorCount> kNames = {"right", "merged", "split",
                                                                     "missed", "unjudged"};
  return kNames[static_cast<std::size_t>(error)];
}

std::vector<EdgeError> judge_edges(const std::vector<Edge>& edges,
                                   const std::vector<std::uint32_t>& patch_truth) {
  std::vector<EdgeError> errors;
  errors.reserve(edges.size());
  for (const Edge& edge : edges) {
    const std::uint32_t a = patch_truth[edge.first], b = patch_truth[edge.second];
    errors.push_back(a == 0 || b == 0     ? EdgeError::Unjudged
                     : edge.on && a != b  ? EdgeError::Merged
                     : !edge.on && a == b ? EdgeError::Cut
                                          : EdgeError::None);
  }
  return errors;
}

std::array<std::size_t, kEdgeErrorCount> count_errors(const std::vector<EdgeError>& errors) {
  std::array<std::size_t, kEdgeErrorCount> counts{};
  for (const EdgeError error : errors) ++counts[static_cast<std::size_t>(error)];
  return counts;
}

std::vector<std::size_t> wrong_edges(const std::vector<Edge>& edges,
                                     const std::vector<EdgeError>& errors,
                                     const std::vector<std::uint32_t>& patch_label) {
  std::vector<std::size_t> wrong;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (errors[e] == EdgeError::Merged || errors[e] == EdgeError::Cut) wrong.push_back(e);
  }
  const auto harmless = [&](std::size_t e) {
    return errors[e] == EdgeError::Cut &&
           patch_label[edges[e].first] == patch_label[edges[e].second];
  };
  std::ranges::stable_sort(wrong, [&](std::size_t a, std::size_t b) {
    const bool x = harmless(a), y = harmless(b);
    return x != y ? y : edges[a].border > edges[b].border;
  });
  return wrong;
}

std::vector<PointError> judge_points(std::span<const std::uint32_t> predicted,
                                     std::span<const std::uint32_t> truth) {
  check_lengths(predicted.size(), truth.size());
  std::map<std::uint32_t, Counts> by_segment;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] != 0 && predicted[i] != kNoSegment) ++by_segment[predicted[i]][truth[i]];
  }
  std::map<std::uint32_t, std::uint32_t> main_object;  // of each segment
  std::map<std::uint32_t, Counts> own_segments;        // of each object
  for (const auto& [segment, counts] : by_segment) {
    const auto [object, points] = most(counts);
    main_object[segment] = object;
    own_segments[object][segment] = points;
  }
  std::map<std::uint32_t, std::uint32_t> best;
  for (const auto& [object, segments] : own_segments) best[object] = most(segments).first;
  std::vector<PointError> errors;
  errors.reserve(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint32_t segment = predicted[i];
    errors.push_back(truth[i] == 0                         ? PointError::Unjudged
                     : segment == kNoSegment               ? PointError::Missed
                     : main_object.at(segment) != truth[i] ? PointError::Merged
                     : best.at(truth[i]) != segment        ? PointError::Split
                                                           : PointError::None);
  }
  return errors;
}

std::array<std::size_t, kPointErrorCount> count_errors(const std::vector<PointError>& errors) {
  std::array<std::size_t, kPointErrorCount> counts{};
  for (const PointError error : errors) ++counts[static_cast<std::size_t>(error)];
  return counts;
}

ErrorSummary summarise_errors(const Segmentation& scene, const std::vector<EdgeError>& errors,
                              const std::vector<std::uint32_t>& truth) {
  ErrorSummary summary;
  summary.edges = count_errors(errors);
  summary.points = count_errors(judge_points(scene.point_label, truth));
  const std::vector<std::uint32_t>& label = scene.segments.patch_label;
  for (std::size_t e = 0; e < errors.size(); ++e) {
    const Edge& edge = scene.edges[e];
    const auto rule = static_cast<std::size_t>(edge.rule);
    if (errors[e] == EdgeError::Merged) ++summary.merged_by_rule[rule];
    if (errors[e] != EdgeError::Cut) continue;
    ++summary.cut_by_rule[rule];
    if (label[edge.first] == label[edge.second]) ++summary.harmless_cuts;
  }
  return summary;
}

}  // namespace planescope
