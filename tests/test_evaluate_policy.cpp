// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "planescope/error.hpp"
#include "planescope/evaluate.hpp"

namespace planescope {
namespace {

using Labels = std::vector<std::uint32_t>;

const Labels kTruth = {0, 1, 5, 20, 21, 30};
const Labels kFound = {1, 1, 0, 2, 2, 0};

TEST(TruthPolicy, TheDefaultCountsEveryLabelButZero) {
  EXPECT_EQ(apply_policy(kFound, kTruth, {}), kTruth);
}

TEST(TruthPolicy, LabelsAreLeftOutByNumberBeforeTheyAreMerged) {
  EXPECT_EQ(apply_policy(kFound, kTruth, {.from = 20}), (Labels{0, 0, 0, 20, 21, 30}));
  EXPECT_EQ(apply_policy(kFound, kTruth, {.ignore = {5, 21}}), (Labels{0, 1, 0, 20, 0, 30}));
  EXPECT_EQ(apply_policy(kFound, kTruth, {.divide = 10, .ignore = {21}}),
            (Labels{0, 1, 1, 3, 0, 4}));
}

TEST(TruthPolicy, UnlabelledPointsAreMissedOrIgnored) {
  EXPECT_EQ(apply_policy(kFound, kTruth, {.unlabelled = TruthPolicy::Unlabelled::Ignored}),
            (Labels{0, 1, 0, 20, 21, 0}));
  // Half of a region is in no segment: overlap 1/2, or 1 where that half does not count.
  const Labels truth = {1, 1, 1, 1}, half = {7, 7, 0, 0};
  EXPECT_DOUBLE_EQ(score_labels(half, apply_policy(half, truth, {})).weighted_overlap, 0.5);
  const TruthPolicy ignored{.unlabelled = TruthPolicy::Unlabelled::Ignored};
  EXPECT_DOUBLE_EQ(score_labels(half, apply_policy(half, truth, ignored)).weighted_overlap, 1);
}

TEST(TruthPolicy, RefusesOtherLengths) { EXPECT_THROW(apply_policy(Labels{1}, kTruth, {}), Error); }

TEST(ObjectScores, AreOverTheObjectsAloneButWithWholeSegments) {
  // Table 1 of 4 points, object 20 of 2 (all of it, and one point of the table, in segment 9),
  // object 30 of 1, missed.
  const Labels truth = {1, 1, 1, 1, 20, 20, 30}, found = {1, 1, 1, 9, 9, 9, 0};
  const ObjectScores objects = score_objects(score_labels(found, truth), 20);
  EXPECT_EQ(objects.regions, 2U);
  EXPECT_DOUBLE_EQ(objects.overlap, (2.0 / 3 + 0) / 2);
  EXPECT_DOUBLE_EQ(objects.weighted_overlap, 2 * (2.0 / 3) / 3);
  const auto merged = apply_policy(found, truth, {.divide = 10});
  EXPECT_DOUBLE_EQ(score_objects(score_labels(found, merged), 20, 10).overlap, objects.overlap);
  EXPECT_EQ(score_objects(score_labels(found, truth), 40).regions, 0U);
}

}  // namespace
}  // namespace planescope
