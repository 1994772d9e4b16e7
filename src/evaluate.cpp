// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

#include "planescope/error.hpp"

namespace planescope {
namespace {

// The points that a truth region and a segment have in common.
struct Cell {
  std::uint32_t truth = 0, predicted = 0;
  std::uint64_t points = 0;
};

// The contingency table of truth and prediction, over points with truth. Cells are sorted by truth
// label, then by predicted label, so that sums over them do not depend on how they were counted.
struct Contingency {
  std::vector<Cell> cells;
  std::unordered_map<std::uint32_t, std::uint64_t> truth_points, predicted_points;
  std::uint64_t points = 0;
};

Contingency count(std::span<const std::uint32_t> predicted, std::span<const std::uint32_t> truth) {
  std::unordered_map<std::uint64_t, std::uint64_t> cells;
  std::uint64_t last_key = 0;
  std::uint64_t* last = nullptr;  // clouds are coherent: the next point is mostly of the same cell
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) continue;
    const std::uint64_t key = (std::uint64_t{truth[i]} << 32) | predicted[i];
    if (last == nullptr || key != last_key) {
      last = &cells[key];
      last_key = key;
    }
    ++*last;
  }
  Contingency table;
  table.cells.reserve(cells.size());
  for (const auto& [key, points] : cells) {
    const Cell cell{static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key), points};
    table.cells.push_back(cell);
    table.truth_points[cell.truth] += points;
    table.predicted_points[cell.predicted] += points;
    table.points += points;
  }
  std::sort(table.cells.begin(), table.cells.end(), [](const Cell& a, const Cell& b) {
    return a.truth != b.truth ? a.truth < b.truth : a.predicted < b.predicted;
  });
  return table;
}

// Eqs. (11) and (12), and F_os: what each region's best segment covers of it.
void score_regions(const Contingency& table, LabelScores& scores) {
  double weighted = 0, plain = 0, covered = 0;
  for (std::size_t first = 0, next = 0; first < table.cells.size(); first = next) {
    RegionScore region;
    region.truth = table.cells[first].truth;
    region.points = table.truth_points.at(region.truth);
    std::uint64_t largest = 0;
    for (; next < table.cells.size() && table.cells[next].truth == region.truth; ++next) {
      const Cell& cell = table.cells[next];
      if (cell.predicted == kNoSegment) continue;
      const std::uint64_t both =
          region.points + table.predicted_points.at(cell.predicted) - cell.points;
      const double overlap = static_cast<double>(cell.points) / static_cast<double>(both);
      largest = std::max(largest, cell.points);
      if (overlap > region.overlap) {  // of equals the first, which has the lowest label
        region.overlap = overlap;
        region.predicted = cell.predicted;
      }
    }
    const auto size = static_cast<double>(region.points);
    weighted += size * region.overlap;
    plain += region.overlap;
    covered += static_cast<double>(largest) / size;
    scores.per_region.push_back(region);
  }
  const auto regions = static_cast<double>(scores.per_region.size());
  scores.regions = static_cast<std::uint32_t>(scores.per_region.size());
  scores.weighted_overlap = weighted / static_cast<double>(table.points);
  scores.overlap = plain / regions;
  scores.over_segmentation = 1 - covered / regions;
}

// F_us, and the number of segments.
void score_segments(const Contingency& table, LabelScores& scores) {
  std::unordered_map<std::uint32_t, std::uint64_t> main_region;  // points of each segment in it
  std::uint64_t in_segments = 0, in_main_regions = 0;
  for (const Cell& cell : table.cells) {
    if (cell.predicted == kNoSegment) continue;
    std::uint64_t& main = main_region[cell.predicted];
    main = std::max(main, cell.points);
    in_segments += cell.points;
  }
  for (const auto& [segment, points] : main_region) in_main_regions += points;
  scores.segments = static_cast<std::uint32_t>(main_region.size());
  scores.under_segmentation =
      in_segments == 0
          ? 0
          : static_cast<double>(in_segments - in_main_regions) / static_cast<double>(in_segments);
}

// Exact for up to 2^32 points.
std::uint64_t pairs(std::uint64_t n) { return n % 2 == 0 ? n / 2 * (n - 1) : n * ((n - 1) / 2); }

double adjusted_rand(const Contingency& table) {
  std::uint64_t together = 0, in_truth = 0, in_segments = 0;  // pairs; whole numbers add exactly
  for (const Cell& cell : table.cells) {
    if (cell.predicted != kNoSegment) together += pairs(cell.points);
  }
  for (const auto& [label, points] : table.truth_points) in_truth += pairs(points);
  for (const auto& [label, points] : table.predicted_points) {
    if (label != kNoSegment) in_segments += pairs(points);
  }
  const std::uint64_t all = pairs(table.points);
  // Both one class, or both all singletons: they agree, where the formula says 0 / 0.
  if (in_truth == in_segments && (in_truth == 0 || in_truth == all)) return 1;
  const double expected =
      static_cast<double>(in_truth) * (static_cast<double>(in_segments) / static_cast<double>(all));
  const double most = (static_cast<double>(in_truth) + static_cast<double>(in_segments)) / 2;
  return (static_cast<double>(together) - expected) / (most - expected);
}

double variation_of_information(const Contingency& table) {
  double sum = 0;
  for (const Cell& cell : table.cells) {
    const auto n = static_cast<double>(cell.points);
    const auto region = static_cast<double>(table.truth_points.at(cell.truth));
    const auto segment = static_cast<double>(table.predicted_points.at(cell.predicted));
    sum += n * (std::log2(region / n) + std::log2(segment / n));
  }
  return sum / static_cast<double>(table.points);
}

}  // namespace

LabelScores score_labels(std::span<const std::uint32_t> predicted,
                         std::span<const std::uint32_t> truth) {
  if (predicted.size() != truth.size()) {
    throw Error(Error::Kind::Input, "scores: " + std::to_string(predicted.size()) +
                                        " predicted labels and " + std::to_string(truth.size()) +
                                        " true ones; expected the same points in the same order");
  }
  const Contingency table = count(predicted, truth);
  if (table.points == 0) {
    throw Error(Error::Kind::Input,
                "scores: no point has a true label other than 0; give a truth that has");
  }
  LabelScores scores;
  score_regions(table, scores);
  score_segments(table, scores);
  scores.adjusted_rand = adjusted_rand(table);
  scores.variation_of_information = variation_of_information(table);
  return scores;
}

std::vector<std::uint32_t> merge_truth(std::span<const std::uint32_t> labels,
                                       std::uint32_t divide) {
  if (divide == 0) throw Error(Error::Kind::Usage, "truth labels are divided by 0; expected 1 up");
  std::vector<std::uint32_t> merged(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const std::uint32_t object = labels[i] / divide;
    if (object == std::numeric_limits<std::uint32_t>::max()) {
      throw Error(Error::Kind::Input, "true label " + std::to_string(labels[i]) + " of point " +
                                          std::to_string(i) + " is too large; expected less");
    }
    merged[i] = labels[i] == 0 ? 0 : object + 1;
  }
  return merged;
}

}  // namespace planescope
