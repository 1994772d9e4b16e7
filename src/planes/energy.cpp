// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <tbb/parallel_for.h>
#include <Eigen/Geometry>

#include "planes/held_planes.hpp"

namespace planescope {
namespace {

/// 1 - exp(-deviation / alpha); without tolerance every deviation costs all.
double angle_cost(double deviation, double alpha) {
  if (alpha <= 0) return deviation > 0 ? 1 : 0;
  return 1 - std::exp(-deviation / alpha);
}

double overlap_cost(const Hypothesis& a, const Hypothesis& b) {
  const std::uint32_t smaller = std::min(a.support, b.support);
  return smaller == 0 ? 0 : static_cast<double>(count_common(a.inliers, b.inliers)) / smaller;
}

/// Per hypothesis: its inliers and all patches next to one, as positions in the index.
std::vector<Bits> reached(const std::vector<Hypothesis>& hypotheses, const PatchIndex& index,
                          const PatchGraph& graph) {
  std::vector<std::uint32_t> position(graph.patches.size());
  for (std::uint32_t i = 0; i < index.size(); ++i) position[index.patch(i)] = i;
  std::vector<Bits> result(hypotheses.size());
  tbb::parallel_for(std::size_t{0}, hypotheses.size(), [&](std::size_t m) {
    const Bits& members = hypotheses[m].inliers;
    result[m] = members;
    for (const Adjacency& edge : graph.adjacency) {
      const std::uint32_t a = position[edge.first], b = position[edge.second];
      if (contains(members, a)) insert(result[m], b);
      if (contains(members, b)) insert(result[m], a);
    }
  });
  return result;
}

}  // namespace

double data_cost(double inliers, double lambda) {
  const double surplus = (lambda - inliers) / lambda;  // 1 - |I| / lambda
  return inliers < lambda ? surplus : std::expm1(surplus);
}

double manhattan_deviation(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Vector3d u = a.cast<double>(), v = b.cast<double>();
  // atan2 of sine and cosine: acos alone loses half of the digits near 0.
  const double angle = std::atan2(u.cross(v).norm(), std::abs(u.dot(v))) * 180 / std::numbers::pi;
  return std::min(angle, 90 - angle);
}

double SelectionEnergy::operator()(const std::vector<bool>& x) const {
  const std::size_t n = size();
  double sum = 0;
  for (std::size_t m = 0; m < n; ++m) {
    if (!x[m]) continue;
    sum += unary[m];
    for (std::size_t k = m + 1; k < n; ++k) {
      if (x[k]) sum += pairwise[m * n + k];
    }
  }
  return sum;
}

PairTerms pair_terms(const std::vector<Hypothesis>& hypotheses, const PatchIndex& index,
                     const PatchGraph& graph, const PlaneOptions& options) {
  const std::size_t n = hypotheses.size();
  const bool touching = options.angle_scope == AngleScope::Touching;
  const std::vector<Bits> reach =
      touching ? reached(hypotheses, index, graph) : std::vector<Bits>();
  PairTerms terms{std::vector<double>(n * n, 0), std::vector<double>(n * n, 0)};
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t m) {
    for (std::size_t k = 0; k < m; ++k) {
      const Hypothesis &a = hypotheses[m], &b = hypotheses[k];
      const bool pays = options.weight_angle > 0 && (!touching || any_common(reach[m], b.inliers));
      const double angle =
          pays ? options.weight_angle *
                     angle_cost(manhattan_deviation(a.plane.normal, b.plane.normal), options.alpha)
               : 0;
      terms.angle[m * n + k] = terms.angle[k * n + m] = angle;
      terms.overlap[m * n + k] = terms.overlap[k * n + m] =
          options.weight_overlap * overlap_cost(a, b);
    }
  });
  return terms;
}

SelectionEnergy selection_energy(const std::vector<Hypothesis>& hypotheses, const PairTerms& pairs,
                                 double lambda) {
  SelectionEnergy energy;
  for (const Hypothesis& h : hypotheses) {
    energy.unary.push_back(data_cost(h.support, lambda) - (h.held ? kHoldBonus : 0));
  }
  energy.pairwise.resize(pairs.angle.size());
  std::transform(pairs.angle.begin(), pairs.angle.end(), pairs.overlap.begin(),
                 energy.pairwise.begin(), std::plus<>());
  return energy;
}

std::vector<double> flip_costs(const SelectionEnergy& energy, const std::vector<bool>& x) {
  const std::size_t n = energy.size();
  std::vector<double> costs = energy.unary;
  for (std::size_t m = 0; m < n; ++m) {
    for (std::size_t k = 0; k < n; ++k) {
      if (x[k] && k != m) costs[m] += energy.pairwise[m * n + k];
    }
  }
  return costs;
}

}  // namespace planescope
