// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <tuple>

#include <Eigen/Geometry>

#include "planescope/evaluate.hpp"

namespace planescope {
namespace {

using Eigen::Vector3d;

// True faces that the tolerance cannot tell apart.
struct TrueGroup {
  std::vector<std::size_t> faces;  // the largest first
  double area = 0;
  bool structural = false;
  std::int32_t match = kNone;
};

// How far two planes are apart.
struct Difference {
  double angle = 0, offset = 0;  // [deg], [m]
  double cost = 0;               // both in units of the tolerance
};

// A pair that may be matched.
struct Candidate {
  Difference difference;
  std::size_t group = 0, found = 0;
};

// Angle between two lines in [0, 90] degrees; by atan2, since acos is coarse near 0.
double angle_between(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / std::numbers::pi;
}

// The difference of a plane from a true face, if it is within the tolerance.
std::optional<Difference> compare(const Plane& plane, const TruePlane& face,
                                  const PlaneTolerance& tolerance) {
  const Vector3d normal = plane.normal.cast<double>().normalized();
  Difference difference;
  difference.angle = angle_between(normal, face.plane.normal.cast<double>());
  difference.offset =
      std::abs(normal.dot(face.centroid.cast<double>()) - static_cast<double>(plane.distance));
  if (!(difference.angle <= tolerance.angle && difference.offset <= tolerance.offset)) return {};
  const auto share = [](double value, double limit) { return limit > 0 ? value / limit : 0; };
  difference.cost =
      share(difference.angle, tolerance.angle) + share(difference.offset, tolerance.offset);
  return difference;
}

std::vector<TrueGroup> group_faces(std::span<const TruePlane> truth,
                                   const PlaneTolerance& tolerance) {
  std::vector<std::size_t> order(truth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return truth[a].area > truth[b].area; });
  std::vector<TrueGroup> groups;
  for (const std::size_t face : order) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const TrueGroup& other) {
      return compare(truth[other.faces.front()].plane, truth[face], tolerance).has_value();
    });
    if (group == groups.end()) group = groups.insert(group, TrueGroup{});
    group->faces.push_back(face);
    group->area += truth[face].area;
    group->structural = group->structural || truth[face].structural;
  }
  return groups;
}

// Every found plane with every true one that it may be matched with, nearest first.
std::vector<Candidate> find_candidates(std::span<const Plane> found,
                                       std::span<const TruePlane> truth,
                                       const std::vector<TrueGroup>& groups,
                                       const PlaneTolerance& tolerance) {
  std::vector<Candidate> candidates;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t f = 0; f < found.size(); ++f) {
      std::optional<Difference> nearest;
      for (const std::size_t face : groups[g].faces) {
        const std::optional<Difference> difference = compare(found[f], truth[face], tolerance);
        if (difference && (!nearest || difference->cost < nearest->cost)) nearest = difference;
      }
      if (nearest) candidates.push_back({*nearest, g, f});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.difference.cost, a.group, a.found) <
           std::tuple(b.difference.cost, b.group, b.found);
  });
  return candidates;
}

double ratio(std::size_t part, std::size_t whole) {
  return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

// Matches one to one, and sums up the differences of the matched pairs.
void match(const std::vector<Candidate>& candidates, std::vector<TrueGroup>& groups,
           PlaneScores& scores) {
  std::vector<char> on_truth(scores.found_planes, 0), matched(scores.found_planes, 0);
  std::size_t pairs = 0;
  for (const auto& [difference, group, found] : candidates) {
    on_truth[found] = 1;
    if (groups[group].match != kNone || matched[found] != 0) continue;
    groups[group].match = static_cast<std::int32_t>(found);
    matched[found] = 1;
    ++pairs;
    scores.mean_angle += difference.angle;
    scores.mean_offset += difference.offset;
    scores.max_angle = std::max(scores.max_angle, difference.angle);
    scores.max_offset = std::max(scores.max_offset, difference.offset);
  }
  if (pairs > 0) {
    scores.mean_angle /= static_cast<double>(pairs);
    scores.mean_offset /= static_cast<double>(pairs);
  }
  const auto good = static_cast<std::size_t>(std::count(on_truth.begin(), on_truth.end(), 1));
  scores.invented = static_cast<std::uint32_t>(on_truth.size() - good);
  scores.repeated = static_cast<std::uint32_t>(good - pairs);
  scores.precision = ratio(good, on_truth.size());
}

void score_recall(const std::vector<TrueGroup>& groups, double min_area, PlaneScores& scores) {
  std::size_t matched = 0, structural_matched = 0;
  for (const TrueGroup& group : groups) {
    for (const std::size_t face : group.faces) scores.match[face] = group.match;
    if (group.area < min_area) continue;
    const bool hit = group.match != kNone;
    ++scores.true_planes;
    matched += hit ? 1 : 0;
    if (!group.structural) continue;
    ++scores.structural_planes;
    structural_matched += hit ? 1 : 0;
  }
  scores.recall = ratio(matched, scores.true_planes);
  scores.structural_recall = ratio(structural_matched, scores.structural_planes);
}

double mean_manhattan_deviation(std::span<const Plane> found) {
  double sum = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t j = i + 1; j < found.size(); ++j, ++pairs) {
      const double angle =
          angle_between(found[i].normal.cast<double>(), found[j].normal.cast<double>());
      sum += std::min(angle, 90 - angle);
    }
  }
  return pairs == 0 ? 0 : sum / static_cast<double>(pairs);
}

}  // namespace

PlaneScores score_planes(std::span<const Plane> found, std::span<const TruePlane> truth,
                         const PlaneTolerance& tolerance) {
  PlaneScores scores;
  scores.found_planes = static_cast<std::uint32_t>(found.size());
  scores.match.assign(truth.size(), kNone);
  std::vector<TrueGroup> groups = group_faces(truth, tolerance);
  match(find_candidates(found, truth, groups, tolerance), groups, scores);
  score_recall(groups, tolerance.min_area, scores);
  scores.manhattan_deviation = mean_manhattan_deviation(found);
  return scores;
}

}  // namespace planescope
