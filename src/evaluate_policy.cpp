// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"

namespace planescope {

std::vector<std::uint32_t> apply_policy(std::span<const std::uint32_t> predicted,
                                        std::span<const std::uint32_t> truth,
                                        const TruthPolicy& policy) {
  if (predicted.size() != truth.size()) {
    throw Error(Error::Kind::Input, "scores: " + std::to_string(predicted.size()) +
                                        " predicted labels and " + std::to_string(truth.size()) +
                                        " true ones; expected the same points in the same order");
  }
  std::vector<std::uint32_t> counted(truth.begin(), truth.end());
  for (std::size_t i = 0; i < counted.size(); ++i) {
    const bool ignored =
        counted[i] < policy.from ||
        std::find(policy.ignore.begin(), policy.ignore.end(), counted[i]) != policy.ignore.end() ||
        (predicted[i] == kNoSegment && policy.unlabelled == TruthPolicy::Unlabelled::Ignored);
    if (ignored) counted[i] = 0;
  }
  return policy.divide == 1 ? counted : merge_truth(counted, policy.divide);
}

ObjectScores score_objects(const LabelScores& scores, std::uint32_t first, std::uint32_t divide) {
  const std::uint32_t lowest = divide > 1 ? first / divide + 1 : first;  // of merge_truth()
  ObjectScores objects;
  double points = 0;
  for (const RegionScore& region : scores.per_region) {
    if (region.truth < lowest) continue;
    const auto size = static_cast<double>(region.points);
    points += size;
    ++objects.regions;
    objects.weighted_overlap += size * region.overlap;
    objects.overlap += region.overlap;
  }
  if (objects.regions == 0) return objects;
  objects.weighted_overlap /= points;
  objects.overlap /= objects.regions;
  return objects;
}

}  // namespace planescope
