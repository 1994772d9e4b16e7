// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/evaluate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "planescope/error.hpp"

namespace planescope {
namespace {

using Labels = std::vector<std::uint32_t>;

// n times `label`, added to what is there.
void add(Labels& labels, int n, std::uint32_t label) {
  labels.insert(labels.end(), static_cast<std::size_t>(n), label);
}

// The same scores by their definitions over sets and pairs of points, slowly.
struct SlowScores {
  double weighted = 0, plain = 0, over = 0, under = 0, rand = 0, information = 0;
};

SlowScores score_slowly(const Labels& predicted, const Labels& truth) {
  std::map<std::uint32_t, std::set<std::size_t>> regions, segments;
  std::size_t n = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) continue;
    ++n;
    regions[truth[i]].insert(i);
    if (predicted[i] != 0) segments[predicted[i]].insert(i);
  }
  const auto shared = [](const std::set<std::size_t>& a, const std::set<std::size_t>& b) {
    return static_cast<double>(
        std::count_if(a.begin(), a.end(), [&](std::size_t i) { return b.contains(i); }));
  };
  SlowScores scores;
  const auto total = static_cast<double>(n), count = static_cast<double>(regions.size());
  for (const auto& [r, region] : regions) {
    double best = 0, largest = 0;
    for (const auto& [s, segment] : segments) {
      std::set<std::size_t> both = region;
      both.insert(segment.begin(), segment.end());
      best = std::max(best, shared(region, segment) / static_cast<double>(both.size()));
      largest = std::max(largest, shared(region, segment));
    }
    scores.weighted += static_cast<double>(region.size()) * best / total;
    scores.plain += best / count;
    scores.over += (1 - largest / static_cast<double>(region.size())) / count;
  }
  double inside = 0, outside = 0;
  for (const auto& [s, segment] : segments) {
    double largest = 0;
    for (const auto& [r, region] : regions) largest = std::max(largest, shared(region, segment));
    outside += static_cast<double>(segment.size()) - largest;
    inside += static_cast<double>(segment.size());
  }
  scores.under = inside == 0 ? 0 : outside / inside;
  // ARI over all pairs of points (a: together in both, b: in truth, c: in prediction).
  double a = 0, b = 0, c = 0, pairs = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = i + 1; j < truth.size(); ++j) {
      if (truth[i] == 0 || truth[j] == 0) continue;
      const bool in_truth = truth[i] == truth[j];
      const bool in_segment = predicted[i] == predicted[j] && predicted[i] != 0;
      ++pairs;
      a += in_truth && in_segment ? 1 : 0;
      b += in_truth ? 1 : 0;
      c += in_segment ? 1 : 0;
    }
  }
  const double expected = pairs > 0 ? b * c / pairs : 0;
  scores.rand = (b + c) / 2 == expected ? 1 : (a - expected) / ((b + c) / 2 - expected);
  // VoI = 2 H(R, S) - H(R) - H(S).
  std::map<std::uint32_t, double> p, q;
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> joint;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] == 0) continue;
    p[truth[i]] += 1 / total;
    q[predicted[i]] += 1 / total;
    joint[{truth[i], predicted[i]}] += 1 / total;
  }
  for (const auto& [key, x] : joint) scores.information -= 2 * x * std::log2(x);
  for (const auto& [key, x] : p) scores.information += x * std::log2(x);
  for (const auto& [key, x] : q) scores.information += x * std::log2(x);
  return scores;
}

TEST(ScoreLabels, PerfectWhateverTheNames) {
  Labels truth, predicted;
  add(truth, 30, 7), add(truth, 20, 2), add(truth, 50, 9);
  add(predicted, 30, 2), add(predicted, 20, 900), add(predicted, 50, 1);
  const LabelScores scores = score_labels(predicted, truth);
  EXPECT_EQ(scores.weighted_overlap, 1);
  EXPECT_EQ(scores.overlap, 1);
  EXPECT_EQ(scores.over_segmentation, 0);
  EXPECT_EQ(scores.under_segmentation, 0);
  EXPECT_EQ(scores.adjusted_rand, 1);
  EXPECT_EQ(scores.variation_of_information, 0);
  EXPECT_EQ(scores.regions, 3u);
  EXPECT_EQ(scores.segments, 3u);
  ASSERT_EQ(scores.per_region.size(), 3u);
  EXPECT_EQ(scores.per_region[0].truth, 2u);
  EXPECT_EQ(scores.per_region[0].predicted, 900u);
  EXPECT_EQ(scores.per_region[0].points, 20u);
  EXPECT_EQ(scores.per_region[2].truth, 9u);
  EXPECT_EQ(scores.per_region[2].predicted, 1u);
}

TEST(ScoreLabels, AllInOneSegment) {
  Labels truth, predicted;
  add(truth, 60, 1), add(truth, 40, 2);
  add(predicted, 100, 5);
  const LabelScores scores = score_labels(predicted, truth);
  EXPECT_DOUBLE_EQ(scores.weighted_overlap, 0.6 * 0.6 + 0.4 * 0.4);
  EXPECT_DOUBLE_EQ(scores.overlap, 0.5);
  EXPECT_DOUBLE_EQ(scores.over_segmentation, 0);
  EXPECT_DOUBLE_EQ(scores.under_segmentation, 0.4);
  EXPECT_NEAR(scores.adjusted_rand, 0, 1e-12);
  const double entropy = -0.6 * std::log2(0.6) - 0.4 * std::log2(0.4);
  EXPECT_NEAR(scores.variation_of_information, entropy, 1e-12);
}

TEST(ScoreLabels, AllSingletons) {
  Labels truth, predicted;
  add(truth, 6, 1), add(truth, 4, 2);
  for (std::uint32_t i = 1; i <= 10; ++i) predicted.push_back(i);
  const LabelScores scores = score_labels(predicted, truth);
  EXPECT_NEAR(scores.weighted_overlap, 0.6 / 6 + 0.4 / 4, 1e-12);
  EXPECT_NEAR(scores.overlap, (1.0 / 6 + 1.0 / 4) / 2, 1e-12);
  EXPECT_NEAR(scores.over_segmentation, 1 - (1.0 / 6 + 1.0 / 4) / 2, 1e-12);
  EXPECT_EQ(scores.under_segmentation, 0);
  EXPECT_NEAR(scores.adjusted_rand, 0, 1e-12);
  EXPECT_NEAR(scores.variation_of_information, 0.6 * std::log2(6) + 0.4 * std::log2(4), 1e-12);
  EXPECT_EQ(scores.segments, 10u);
  EXPECT_EQ(scores.per_region[0].predicted, 1u) << "of equals the lowest label";
  EXPECT_EQ(scores.per_region[1].predicted, 7u);
}

TEST(ScoreLabels, UnlabelledHalves) {
  Labels truth, predicted;
  add(truth, 50, 1), add(truth, 50, 2);
  add(predicted, 25, 8), add(predicted, 25, 0), add(predicted, 25, 9), add(predicted, 25, 0);
  const LabelScores scores = score_labels(predicted, truth);
  EXPECT_DOUBLE_EQ(scores.weighted_overlap, 0.5);
  EXPECT_DOUBLE_EQ(scores.overlap, 0.5);
  EXPECT_DOUBLE_EQ(scores.over_segmentation, 0.5);
  EXPECT_EQ(scores.under_segmentation, 0);
  EXPECT_EQ(scores.segments, 2u);
  // Pairs: together in both 2 C(25,2) = 600; in truth 2 C(50,2) = 2450; predicted 600; all 4950.
  const double expected = 2450.0 * 600 / 4950;
  EXPECT_NEAR(scores.adjusted_rand, (600 - expected) / ((2450 + 600) / 2.0 - expected), 1e-12);
  // Three classes of the prediction, 1/4, 1/4, 1/2; the last is cut in halves by the truth.
  // H(R|S) = 1/2 bit, H(S|R) = 1 bit.
  EXPECT_NEAR(scores.variation_of_information, 1.5, 1e-12);
}

TEST(ScoreLabels, PointsWithoutTruthDoNotCount) {
  Labels truth = {1, 1, 0, 0, 0}, predicted = {3, 3, 3, 3, 4};
  const LabelScores scores = score_labels(predicted, truth);
  EXPECT_EQ(scores.weighted_overlap, 1);
  EXPECT_EQ(scores.segments, 1u);
  EXPECT_EQ(scores.adjusted_rand, 1);
}

TEST(ScoreLabels, NothingPredicted) {
  const LabelScores scores = score_labels(Labels(10, 0), Labels(10, 4));
  EXPECT_EQ(scores.weighted_overlap, 0);
  EXPECT_EQ(scores.overlap, 0);
  EXPECT_EQ(scores.over_segmentation, 1);
  EXPECT_EQ(scores.under_segmentation, 0);
  EXPECT_EQ(scores.adjusted_rand, 0);
  EXPECT_EQ(scores.per_region[0].predicted, kNoSegment);
}

TEST(ScoreLabels, AgreesWithTheDefinitionsOverSetsAndPairs) {
  std::mt19937 engine(5);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  for (int round = 0; round < 200; ++round) {
    const auto n = 1 + random() % 60;
    const std::uint32_t regions = 1 + random() % 6, segments = 1 + random() % 8;
    Labels truth, predicted;
    for (std::size_t i = 0; i < n; ++i) {
      truth.push_back(i == 0 ? 1 : random() % (regions + 1));
      predicted.push_back(random() % 3 == 0 ? truth.back() : random() % (segments + 1));
    }
    const LabelScores fast = score_labels(predicted, truth);
    const SlowScores slow = score_slowly(predicted, truth);
    ASSERT_NEAR(fast.weighted_overlap, slow.weighted, 1e-9);
    ASSERT_NEAR(fast.overlap, slow.plain, 1e-9);
    ASSERT_NEAR(fast.over_segmentation, slow.over, 1e-9);
    ASSERT_NEAR(fast.under_segmentation, slow.under, 1e-9);
    ASSERT_NEAR(fast.adjusted_rand, slow.rand, 1e-9);
    ASSERT_NEAR(fast.variation_of_information, slow.information, 1e-9);
  }
}

TEST(ScoreLabels, LargeCountsDoNotOverflow) {
  Labels truth(3'000'000, 1), predicted(3'000'000, 1);
  std::fill(truth.begin() + 1'000'000, truth.end(), 2);
  std::fill(predicted.begin() + 1'000'000, predicted.end(), 2);
  EXPECT_EQ(score_labels(predicted, truth).adjusted_rand, 1);
  predicted[0] = 2;
  EXPECT_NEAR(score_labels(predicted, truth).adjusted_rand, 1, 1e-5);
}

TEST(ScoreLabels, RefusesWhatCannotBeScored) {
  const auto kind_of = [](const Labels& predicted, const Labels& truth) {
    try {
      score_labels(predicted, truth);
    } catch (const Error& error) {
      return error.kind();
    }
    return Error::Kind::Internal;
  };
  EXPECT_EQ(kind_of({1}, {1, 2}), Error::Kind::Input);
  EXPECT_EQ(kind_of({1, 1}, {0, 0}), Error::Kind::Input);
  EXPECT_EQ(kind_of({}, {}), Error::Kind::Input);
}

TEST(MergeTruth, JoinsThePartsOfAnObject) {
  EXPECT_EQ(merge_truth(Labels{0, 1, 9, 20, 29, 30}, 10), (Labels{0, 1, 1, 3, 3, 4}));
  EXPECT_EQ(merge_truth(Labels{0, 5}, 1), (Labels{0, 6}));
  EXPECT_THROW(merge_truth(Labels{1}, 0), Error);
  EXPECT_THROW(merge_truth(Labels{0xffffffff}, 1), Error);
}

TEST(ScoreBoundaries, WithinTheToleranceIsFound) {
  // Rows of 12: the truth changes after column 5, the prediction 1 to 5 columns later.
  const auto image = [](std::uint32_t change) {
    Labels labels;
    for (int row = 0; row < 4; ++row) {
      for (std::uint32_t column = 0; column < 12; ++column)
        labels.push_back(column < change ? 1 : 2);
    }
    return labels;
  };
  const Labels truth = image(6);  // border pixels: columns 5 and 6
  for (const std::uint32_t change : {6u, 7u, 8u}) {
    const BoundaryScores scores = score_boundaries(image(change), truth, 12);
    EXPECT_EQ(scores.recall, 1) << change;
    EXPECT_EQ(scores.precision, 1) << change;
  }
  const BoundaryScores half = score_boundaries(image(9), truth, 12);  // columns 8 and 9
  EXPECT_EQ(half.recall, 0.5);                                        // 6 is two from 8, 5 is three
  EXPECT_EQ(half.precision, 0.5);
  const BoundaryScores none = score_boundaries(image(11), truth, 12);
  EXPECT_EQ(none.recall, 0);
  EXPECT_EQ(none.precision, 0);
  const BoundaryScores flat = score_boundaries(Labels(48, 1), truth, 12);
  EXPECT_EQ(flat.recall, 0);
  EXPECT_EQ(flat.precision, 1) << "of nothing";
  EXPECT_EQ(score_boundaries(image(9), truth, 12, 0).recall, 0);
  EXPECT_EQ(score_boundaries(image(9), truth, 12, 100).recall, 1);
}

TEST(ScoreBoundaries, NoBorderWithoutTruthAndNoneAcrossTheImagesSides) {
  // Two rows of 3; the last pixel of the first row and the first of the second are not neighbours.
  const Labels truth = {1, 1, 2, 1, 1, 2};
  EXPECT_EQ(score_boundaries(truth, truth, 3, 0).recall, 1);
  const Labels holes = {1, 0, 2, 1, 0, 2}, flat(6, 1);
  EXPECT_EQ(score_boundaries(flat, holes, 3, 0).recall, 1) << "no border, a share of nothing";
  EXPECT_EQ(score_boundaries(Labels{1, 2, 3, 4, 5, 6}, holes, 3, 0).precision, 0);
  EXPECT_THROW(score_boundaries(truth, truth, 4), Error);
  EXPECT_THROW(score_boundaries(truth, truth, 0), Error);
  EXPECT_THROW(score_boundaries(flat, Labels(3, 1), 3), Error);
}

}  // namespace
}  // namespace planescope
