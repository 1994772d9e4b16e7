// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planes/hypotheses.hpp"
#include "planes_fixtures.hpp"
#include "planescope/planes.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;
using V = Eigen::Vector3f;

/// A floor of 100 patches, then a wall of 50 at x = 2.
struct Corner {
  Corner() {
    PatchGraphBuilder builder(0.2f, 0.002f, 0.02f, 3);
    builder.rectangle(V(0, 0, 0), V(2, 0, 0), V(0, 2, 0));
    builder.rectangle(V(2, 0, 0), V(0, 0, 1), V(0, 2, 0));
    patches = builder.patches();
  }

  std::vector<Hypothesis> renew(const std::vector<HeldPlane>& held, bool floor_is_fresh,
                                bool wall_is_fresh) const {
    std::vector<std::uint8_t> fresh(patches.size(), wall_is_fresh ? 1 : 0);
    std::fill_n(fresh.begin(), 100, floor_is_fresh ? 1 : 0);
    const PatchIndex index(patches);
    return renew_hypotheses(index, PlaneOptions(), 20, held, fresh).kept;
  }

  std::vector<Patch> patches;
};

/// A floor that was held 2 cm too high and a degree askew, as it was before more of it was seen.
const HeldPlane kOldFloor{{V(std::sin(0.0175f), 0, std::cos(0.0175f)), 0.02f}, true};

TEST(RenewHypotheses, HeldPlanesMoveToThePatchesAsTheyAre) {
  const Corner corner;
  const std::vector<Hypothesis> found = corner.renew({kOldFloor}, false, false);
  ASSERT_EQ(found.size(), 1u);  // the wall is there, but none of its patches may propose
  EXPECT_GT(found[0].plane.normal.z(), 0.9998f);
  EXPECT_NEAR(found[0].plane.distance, 0, 0.003);
  EXPECT_EQ(found[0].support, 100u);
  EXPECT_TRUE(found[0].held);
}

TEST(RenewHypotheses, FreshPatchesProposeWhatIsNotHeld) {
  const Corner corner;
  const std::vector<Hypothesis> found = corner.renew({kOldFloor}, true, true);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].held);  // the fresh floor proposes nothing beside the one that is held
  EXPECT_EQ(found[1].support, 50u);
  EXPECT_GT(std::abs(found[1].plane.normal.x()), 0.999f);
  EXPECT_NEAR(std::abs(found[1].plane.distance), 2, 0.005);
  EXPECT_FALSE(found[1].held);
}

TEST(RenewHypotheses, WhatIsNoLongerThereIsLetGo) {
  const Corner corner;
  const HeldPlane gone{{V(0, 0, 1), 1.5f}, true};  // a table that was carried out
  EXPECT_TRUE(corner.renew({gone}, false, false).empty());
}

TEST(RenewHypotheses, WithNothingHeldItFindsWhatProposalsFind) {
  const Corner corner;
  const PatchIndex index(corner.patches);
  const std::vector<Hypothesis> whole = propose_hypotheses(index, PlaneOptions(), 20).kept;
  const std::vector<Hypothesis> found = corner.renew({}, true, true);
  for (const Hypothesis& f : found) {
    const auto same = [&](const Hypothesis& w) {
      return std::abs(w.plane.normal.dot(f.plane.normal)) > 0.9999f && w.support == f.support;
    };
    EXPECT_TRUE(std::ranges::any_of(whole, same));
  }
  EXPECT_EQ(found.size(), 2u);
}

}  // namespace
}  // namespace planescope
