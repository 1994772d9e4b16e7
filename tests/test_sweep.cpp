// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "planescope/error.hpp"
#include "planescope/sweep.hpp"
#include "planescope/synthesize.hpp"

namespace planescope {
namespace {

using Texts = std::vector<std::string>;

struct Room {
  PointCloud cloud;
  Segmentation scene;
};

const Room& room() {
  static const Room kRoom = [] {
    SynthesisOptions options;
    options.random_seed = 5;
    options.points = 40'000;
    Room made{synthesize(options).cloud, {}};
    made.scene = segment(made.cloud, Options::automatic(made.cloud));
    return made;
  }();
  return kRoom;
}

TEST(Sweep, RangesAndListsAreRead) {
  EXPECT_EQ(parse_sweep("edges.concavity_tolerance=5:6:0.5").values, (Texts{"5", "5.5", "6"}));
  EXPECT_EQ(parse_sweep("planes.sigma=0.03:0.01:-0.01").values, (Texts{"0.03", "0.02", "0.01"}));
  EXPECT_EQ(parse_sweep("planes.sigma=0.1:0.3:0.1").values, (Texts{"0.1", "0.2", "0.3"}));
  EXPECT_EQ(parse_sweep("planes.solver=lsa_tr,lsa_tr+tabu").values,
            (Texts{"lsa_tr", "lsa_tr+tabu"}));
  EXPECT_EQ(parse_sweep("edges.extended_convexity=true,false").option, "edges.extended_convexity");
  for (const char* bad : {"", "planes.sigma", "planes.sigma=", "=1:2:1", "planes.sigma=1:2",
                          "planes.sigma=1:2:0", "planes.sigma=1:2:-1", "planes.sigma=0:1:1e-6",
                          "planes.sigma=1:x:1", "planes.sgima=1", "planes.sigma=0.1,x"})
    EXPECT_THROW(parse_sweep(bad), Error) << bad;
}

/// Each row against a run of the whole method.
void expect_rows(const SweepRange& range) {
  const Room& r = room();
  const auto rows = sweep(r.scene, r.cloud, range, r.cloud.labels);
  ASSERT_EQ(rows.size(), range.values.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Options options = r.scene.options;
    set_option(options, range.option, range.values[i]);
    const Segmentation then = segment(r.cloud, options);
    EXPECT_EQ(rows[i].value, range.values[i]);
    EXPECT_EQ(rows[i].patches, then.graph.patches.size());
    EXPECT_EQ(rows[i].planes, then.planes.size());
    EXPECT_EQ(rows[i].segments, then.segments.segments.size());
    const auto on = static_cast<std::size_t>(std::ranges::count(then.edges, true, &Edge::on));
    EXPECT_EQ(rows[i].edges_on, on);
    EXPECT_EQ(rows[i].edges_off, then.edges.size() - on);
    ASSERT_TRUE(rows[i].scores.has_value());
    EXPECT_EQ(rows[i].scores->weighted_overlap,
              score_labels(then.point_label, r.cloud.labels).weighted_overlap);
    if (!rows[i].switched_on) continue;
    std::size_t to_on = 0, to_off = 0;
    for (std::size_t e = 0; e < then.edges.size(); ++e) {
      to_on += then.edges[e].on && !r.scene.edges[e].on;
      to_off += !then.edges[e].on && r.scene.edges[e].on;
    }
    EXPECT_EQ(*rows[i].switched_on, to_on);
    EXPECT_EQ(*rows[i].switched_off, to_off);
  }
}

TEST(Sweep, EachRowIsARunOfTheWholeMethod) {
  expect_rows(parse_sweep("edges.concavity_tolerance=5:25:10"));
  expect_rows(parse_sweep("planes.min_area=0.3,1,10"));
  expect_rows(parse_sweep("segments.min_patches=1,8"));
  expect_rows(parse_sweep("patches.weight_normal=1,8"));
}

TEST(Sweep, WhatIsStoredAgreesWithItself) {
  const Room& r = room();
  const std::string now = get_option(r.scene.options, "planes.sigma");
  const auto rows = sweep(r.scene, r.cloud, {"planes.sigma", {now}});
  EXPECT_EQ(rows[0].agreement, 1);
  EXPECT_EQ(rows[0].switched_on, std::size_t{0});
  EXPECT_EQ(rows[0].switched_off, std::size_t{0});
  EXPECT_FALSE(rows[0].scores.has_value());
}

TEST(Sweep, RefusesWhatItCannotRepeat) {
  const Room& r = room();
  Segmentation other = r.scene;
  std::ranges::reverse(other.point_label);
  EXPECT_THROW(sweep(other, r.cloud, {"patches.weight_normal", {"4"}}), Error);
  EXPECT_NO_THROW(sweep(other, r.cloud, {"edges.singular_angle", {"4"}}));
  EXPECT_THROW(sweep(r.scene, r.cloud, {"patches.patch_size", {"0.0005"}}), Error);
  other.method.name = "ransac";
  EXPECT_THROW(sweep(other, r.cloud, {"edges.singular_angle", {"4"}}), Error);
}

TEST(Sweep, CsvHasOneLineARun) {
  const Room& r = room();
  const SweepRange range = parse_sweep("edges.singular_angle=0,30,60");
  std::istringstream csv(sweep_csv(range, sweep(r.scene, r.cloud, range)));
  std::string line;
  std::vector<std::string> lines;
  while (std::getline(csv, line)) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(lines[0].starts_with("edges.singular_angle,patches,planes,segments,"));
  for (const std::string& row : lines)
    EXPECT_EQ(std::ranges::count(row, ','), std::ranges::count(lines[0], ','));
  EXPECT_TRUE(lines[2].starts_with("30,"));
  EXPECT_TRUE(lines[2].ends_with(",,,,"));  // no truth, no scores
}

}  // namespace
}  // namespace planescope
