// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"
#include "planescope/explain.hpp"
#include "planescope/truth_errors.hpp"

namespace planescope {
namespace {

using Labels = std::vector<std::uint32_t>;

TEST(TruthErrors, PatchesHaveTheObjectOfTheirPoints) {
  //                              patch 0: 4 of 5 are object 7; 1: torn; 2: no truth
  const std::vector<std::int32_t> patch = {0, 0, 0, 0, 0, 1, 1, 2, kNone};
  const Labels truth = {7, 7, 7, 7, 9, 7, 9, 0, 9};
  EXPECT_EQ(patch_truth(patch, truth, 3), (Labels{7, 0, 0}));
  EXPECT_EQ(patch_truth(patch, truth, 3, 0.81), (Labels{0, 0, 0}));
  EXPECT_EQ(patch_truth(patch, truth, 3, 0.5), (Labels{7, 7, 0}));  // of equals the lowest
  EXPECT_THROW(patch_truth(patch, Labels{1}, 3), Error);
}

std::vector<Edge> chain_of_five() {
  std::vector<Edge> edges(5);
  for (std::uint32_t i = 0; i < 5; ++i) {
    edges[i].first = i;
    edges[i].second = i + 1;
    edges[i].border = 10 + i;
  }
  return edges;
}

TEST(TruthErrors, EdgesAreJudgedByBothEnds) {
  std::vector<Edge> edges = chain_of_five();
  edges[0].on = edges[2].on = true;
  const Labels truth = {1, 1, 1, 2, 2, 0};
  const auto errors = judge_edges(edges, truth);
  EXPECT_EQ(errors, (std::vector{EdgeError::None, EdgeError::Cut, EdgeError::Merged, EdgeError::Cut,
                                 EdgeError::Unjudged}));
  EXPECT_EQ(count_errors(errors), (std::array<std::size_t, 4>{1, 1, 2, 1}));
  // Edge 1 lies inside one segment: it did no harm, and comes last for all its length.
  const Labels segment = {1, 1, 1, 1, 2, 2};
  EXPECT_EQ(wrong_edges(edges, errors, segment), (std::vector<std::size_t>{3, 2, 1}));
}

TEST(TruthErrors, PointsAreMergedSplitOrMissed) {
  // Segment 5 mainly is object 1, with a point of object 2; object 1 has a second, smaller one, 6.
  const Labels predicted = {5, 5, 5, 5, 6, 7, 0, 7};
  const Labels truth = {1, 1, 1, 2, 1, 2, 2, 0};
  using enum PointError;
  EXPECT_EQ(judge_points(predicted, truth),
            (std::vector{None, None, None, Merged, Split, None, Missed, Unjudged}));
}

TEST(TruthErrors, MergedPointsAreUnderSegmentation) {
  std::mt19937 twister(11);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(twister() % n); };
  for (int round = 0; round < 50; ++round) {
    Labels predicted, truth;
    for (int i = 0; i < 200; ++i) {
      predicted.push_back(below(6));
      truth.push_back(below(4));
    }
    const auto counts = count_errors(judge_points(predicted, truth));
    std::size_t in_segments = 0;
    for (std::size_t i = 0; i < truth.size(); ++i)
      in_segments += truth[i] != 0 && predicted[i] != 0;
    const auto merged = counts[static_cast<std::size_t>(PointError::Merged)];
    EXPECT_DOUBLE_EQ(static_cast<double>(merged) / static_cast<double>(in_segments),
                     score_labels(predicted, truth).under_segmentation);
  }
}

TEST(TruthErrors, SummaryAddsUp) {
  Segmentation scene;
  scene.edges = chain_of_five();
  scene.edges[0].on = scene.edges[2].on = true;
  scene.edges[2].rule = EdgeRule::NearlyFlat;
  scene.segments.patch_label = {1, 1, 1, 1, 2, 2};
  scene.point_label = {1, 1, 2};
  const auto errors = judge_edges(scene.edges, {1, 1, 1, 2, 2, 0});
  const ErrorSummary summary = summarise_errors(scene, errors, {4, 4, 5});
  EXPECT_EQ(summary.edges, (std::array<std::size_t, 4>{1, 1, 2, 1}));
  EXPECT_EQ(summary.merged_by_rule[static_cast<std::size_t>(EdgeRule::NearlyFlat)], 1u);
  EXPECT_EQ(summary.cut_by_rule[static_cast<std::size_t>(EdgeRule::Concave)], 2u);
  EXPECT_EQ(summary.harmless_cuts, 1u);
  EXPECT_EQ(summary.points, (std::array<std::size_t, 5>{3, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace planescope
