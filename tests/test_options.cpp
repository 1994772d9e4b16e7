// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

#include "nearest_name.hpp"
#include "planescope/error.hpp"

namespace planescope {
namespace {

/// The message of the usage error that `act` throws.
template <class Act>
std::string usage_error(Act act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Usage);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(OptionTable, NamesEveryMemberOnce) {
  const auto table = option_table();
  std::set<std::string> names;
  for (const OptionInfo& info : table) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_FALSE(info.range.empty() || info.meaning.empty() || info.unit.empty()) << info.name;
  }
  // Counted by hand in options.hpp: 7 of patches, 16 of planes, 5 of edges, 1 of segments.
  EXPECT_EQ(table.size(), 29u);
  EXPECT_EQ(table.front().name, "patches.voxel_size");
  EXPECT_EQ(table.back().name, "segments.min_patches");
}

TEST(OptionTable, EachNameReachesItsOwnMember) {
  Options o;
  set_option(o, "patches.voxel_size", "0.011");
  set_option(o, "patches.patch_size", "0.12");
  set_option(o, "patches.range_exponent", "0.4");
  set_option(o, "patches.smoothing", "0.02");
  set_option(o, "patches.weight_color", "1.5");
  set_option(o, "patches.weight_spatial", "2.5");
  set_option(o, "patches.weight_normal", "3.5");
  set_option(o, "planes.sigma", "0.03");
  set_option(o, "planes.min_area", "0.7");
  set_option(o, "planes.face_area", "0.06");
  set_option(o, "planes.alpha", "12");
  set_option(o, "planes.normal_gate", "0.9");
  set_option(o, "planes.max_curvature", "0.07");
  set_option(o, "planes.weight_angle", "4.5");
  set_option(o, "planes.weight_overlap", "5.5");
  set_option(o, "planes.angle_scope", "touching");
  set_option(o, "planes.solver", "lsa_tr");
  set_option(o, "planes.assignment", "icm");
  set_option(o, "planes.smoothness", "0.25");
  set_option(o, "planes.triples", "17");
  set_option(o, "planes.max_hypotheses", "23");
  set_option(o, "planes.tabu_steps", "99");
  set_option(o, "planes.random_seed", "18446744073709551615");
  set_option(o, "edges.concavity_tolerance", "11");
  set_option(o, "edges.smoothness_tolerance", "0.2");
  set_option(o, "edges.singular_angle", "45");
  set_option(o, "edges.rim_angle", "130");
  set_option(o, "edges.extended_convexity", "true");
  set_option(o, "segments.min_patches", "8");
  EXPECT_EQ(o.patches.voxel_size, 0.011);
  EXPECT_EQ(o.patches.patch_size, 0.12);
  EXPECT_EQ(o.patches.range_exponent, 0.4);
  EXPECT_EQ(o.patches.smoothing, 0.02);
  EXPECT_EQ(o.planes.face_area, 0.06);
  EXPECT_EQ(o.edges.rim_angle, 130);
  EXPECT_EQ(o.patches.weight_color, 1.5);
  EXPECT_EQ(o.patches.weight_spatial, 2.5);
  EXPECT_EQ(o.patches.weight_normal, 3.5);
  EXPECT_EQ(o.planes.sigma, 0.03);
  EXPECT_EQ(o.planes.min_area, 0.7);
  EXPECT_EQ(o.planes.alpha, 12);
  EXPECT_EQ(o.planes.normal_gate, 0.9);
  EXPECT_EQ(o.planes.max_curvature, 0.07);
  EXPECT_EQ(o.planes.weight_angle, 4.5);
  EXPECT_EQ(o.planes.weight_overlap, 5.5);
  EXPECT_EQ(o.planes.angle_scope, AngleScope::Touching);
  EXPECT_EQ(o.planes.solver, PlaneSolver::LsaTr);
  EXPECT_EQ(o.planes.assignment, AssignmentSolver::Icm);
  EXPECT_EQ(o.planes.smoothness, 0.25);
  EXPECT_EQ(o.planes.triples, 17u);
  EXPECT_EQ(o.planes.max_hypotheses, 23u);
  EXPECT_EQ(o.planes.tabu_steps, 99u);
  EXPECT_EQ(o.planes.random_seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(o.edges.concavity_tolerance, 11);
  EXPECT_EQ(o.edges.smoothness_tolerance, 0.2);
  EXPECT_EQ(o.edges.singular_angle, 45);
  EXPECT_TRUE(o.edges.extended_convexity);
  EXPECT_EQ(o.segments.min_patches, 8u);
  EXPECT_NO_THROW(o.validate());
}

TEST(OptionTable, TextReadsBackToTheSameValue) {
  for (const Options& options : {Options{}, Options::room(), Options::tabletop()}) {
    Options copy;
    for (const OptionInfo& info : option_table()) {
      const std::string text = get_option(options, info.name);
      set_option(copy, info.name, text);
      EXPECT_EQ(get_option(copy, info.name), text) << info.name;
    }
  }
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {  // every bit of an awkward double survives
    Options options, copy;
    options.planes.sigma = 1e-5 + static_cast<double>(random() >> 11) * 0x1p-53;
    set_option(copy, "planes.sigma", get_option(options, "planes.sigma"));
    EXPECT_EQ(std::memcmp(&copy.planes.sigma, &options.planes.sigma, sizeof(double)), 0);
  }
}

TEST(OptionTable, TextIsReadableAndHoldsTinyValuesToo) {
  Options o;
  o.planes.sigma = 0.0001;
  EXPECT_EQ(get_option(o, "planes.sigma"), "0.0001");
  o.planes.weight_angle = 1.25e-300;
  EXPECT_EQ(get_option(o, "planes.weight_angle"), "1.25e-300");
}

TEST(OptionTable, UnknownNameSuggestsTheNearest) {
  Options o;
  EXPECT_TRUE(contains(usage_error([&] { set_option(o, "planes.sgima", "1"); }), "planes.sigma"));
  EXPECT_TRUE(contains(usage_error([&] { set_option(o, "voxelsize", "1"); }), "voxel_size"));
  EXPECT_TRUE(
      contains(usage_error([&] { (void)get_option(o, "singularangle"); }), "singular_angle"));
  EXPECT_THROW((void)get_option(o, ""), Error);
}

TEST(OptionTable, BadTextIsRefusedAndNamesTheRange) {
  const auto set = [](const char* name, const char* value) {
    Options o;
    return usage_error([&] { set_option(o, name, value); });
  };
  EXPECT_EQ(set("planes.sigma", "-1"), "planes.sigma is `-1`; it takes 0.00001 to 10 m");
  EXPECT_EQ(set("edges.extended_convexity", "maybe"),
            "edges.extended_convexity is `maybe`; it takes true | false");
  EXPECT_EQ(set("planes.solver", "best"),
            "planes.solver is `best`; it takes lsa_tr | lsa_tr+tabu | exhaustive");
  for (const char* value : {"", " 1", "1 ", "1m", "0x1", "1,5", "nan", "inf", "1e999", "--1"}) {
    EXPECT_FALSE(set("planes.sigma", value).empty()) << value;
  }
  for (const char* value : {"-1", "1.5", "4294967296", "1e3", "+1"}) {
    EXPECT_FALSE(set("planes.triples", value).empty()) << value;
  }
  EXPECT_FALSE(set("planes.random_seed", "18446744073709551616").empty());
}

TEST(OptionTable, ARefusedValueChangesNothing) {
  Options o;
  EXPECT_THROW(set_option(o, "planes.sigma", "11"), Error);
  EXPECT_EQ(o.planes.sigma, 0.05);
}

TEST(Validate, TakesThePresets) {
  EXPECT_NO_THROW(Options{}.validate());
  EXPECT_NO_THROW(Options::room().validate());
  EXPECT_NO_THROW(Options::tabletop().validate());
  // The paper's lambda of 50 patches, each about R_seed^2 (DESIGN: lambda means a minimum area).
  const Options room = Options::room();
  EXPECT_NEAR(room.planes.min_area / (room.patches.patch_size * room.patches.patch_size), 50, 1e-9);
}

TEST(Validate, RefusesEveryNumberOutsideItsRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto error = [](auto change) {
    Options o;
    change(o);
    return usage_error([&] { o.validate(); });
  };
  EXPECT_TRUE(contains(error([&](Options& o) { o.planes.sigma = nan; }), "planes.sigma is `nan`"));
  EXPECT_TRUE(contains(error([](Options& o) { o.patches.voxel_size = 0; }), "patches.voxel_size"));
  EXPECT_TRUE(contains(error([](Options& o) { o.planes.alpha = 90; }), "0.01 to 45 deg"));
  EXPECT_TRUE(contains(error([](Options& o) { o.segments.min_patches = 0; }), "min_patches"));
  EXPECT_TRUE(contains(error([](Options& o) { o.planes.solver = static_cast<PlaneSolver>(7); }),
                       "planes.solver is `7`"));
}

TEST(Validate, RefusesValuesThatContradictEachOther) {
  const auto error = [](auto change) {
    Options o;
    change(o);
    return usage_error([&] { o.validate(); });
  };
  const std::string same = error([](Options& o) { o.patches.patch_size = o.patches.voxel_size; });
  EXPECT_EQ(same,
            "patches.patch_size is 0.02 m; it must be more than patches.voxel_size, 0.02 m: raise "
            "the one or lower the other");
  EXPECT_TRUE(contains(error([](Options& o) {
                         o.patches.weight_color = o.patches.weight_spatial = 0;
                         o.patches.weight_normal = 0;
                       }),
                       "all 0"));
  EXPECT_TRUE(
      contains(error([](Options& o) { o.planes.solver = PlaneSolver::Exhaustive; }), "at most 24"));
}

TEST(NearestName, IsByEditDistance) {
  const std::vector<std::string> names = {"kitten", "sitting", "a.sitting.room"};
  EXPECT_EQ(nearest_name("kiten", names), "kitten");          // 1 insertion against 4
  EXPECT_EQ(nearest_name("sittin", names), "sitting");        // 1
  EXPECT_EQ(nearest_name("rooms", names), "a.sitting.room");  // last part alone: 1
  EXPECT_EQ(nearest_name("x", {}), "");
}

}  // namespace
}  // namespace planescope
