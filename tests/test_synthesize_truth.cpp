// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "synthesis_fixtures.hpp"

namespace planescope {
namespace {

using namespace testing;
using Eigen::Vector3d;

TEST(Synthesize, TruthSurvivesItsFile) {
  const testing::TemporaryFolder folder;
  SynthesisOptions options = evenly(9, 100);
  options.offset = Vector3d(1000, 2000, -3);
  const SynthesizedScene scene = synthesize(options);
  write_truth(scene, folder / "truth.json");
  const std::vector<TruePlane> same = read_true_planes(folder / "truth.json", scene.cloud.origin);
  const std::vector<TruePlane> world = read_true_planes(folder / "truth.json");
  ASSERT_EQ(same.size(), scene.planes.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    EXPECT_EQ(same[i].name, scene.planes[i].name);
    EXPECT_EQ(same[i].label, scene.planes[i].label);
    EXPECT_EQ(same[i].area, scene.planes[i].area);
    EXPECT_EQ(same[i].structural, scene.planes[i].structural);
    EXPECT_EQ(same[i].plane.normal, scene.planes[i].plane.normal);
    EXPECT_EQ(same[i].plane.distance, scene.planes[i].plane.distance);
    EXPECT_EQ(same[i].centroid, scene.planes[i].centroid);
    EXPECT_NEAR(world[i].plane.signed_distance(world[i].centroid), 0, 1e-3);
    EXPECT_LT((world[i].centroid - same[i].centroid - Eigen::Vector3f(1000, 2000, -3)).norm(),
              1e-3f);
  }
}

TEST(Synthesize, MalformedTruthIsRefusedWithAReason) {
  const testing::TemporaryFolder folder;
  const std::string head = R"({"format":"planescope-truth","version":1,"origin":[0,0,0],"planes":)";
  const auto plane = [&](const std::string& label, const std::string& normal,
                         const std::string& area, const std::string& distance) {
    return head + R"([{"name":"a","structural":true,"centroid":[0,0,0],"label":)" + label +
           R"(,"normal":)" + normal + R"(,"area":)" + area + R"(,"distance":)" + distance + "}]}";
  };
  const auto message_for = [&](const std::string& text) -> std::string {
    testing::write_bytes(folder / "t.json", text);
    try {
      read_true_planes(folder / "t.json");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Input);
      return error.what();
    }
    return "accepted";
  };
  const auto contains = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos && text.find('\n') == std::string::npos;
  };
  EXPECT_EQ(message_for(plane("1", "[0,0,1]", "2", "0.5")), "accepted");
  EXPECT_TRUE(contains(message_for(""), "not JSON at byte"));
  EXPECT_TRUE(contains(message_for("{\"format\":"), "not JSON at byte"));
  EXPECT_TRUE(contains(message_for("[]"), "no member \"format\""));
  EXPECT_TRUE(contains(message_for(R"({"format":"x"})"), "is not \"planescope-truth\""));
  EXPECT_TRUE(contains(message_for(head + "7}"), "\"planes\" is not a list"));
  EXPECT_TRUE(contains(message_for(head + "[7]}"), "planes[0]: no member \"name\""));
  EXPECT_TRUE(contains(message_for(plane("-1", "[0,0,1]", "2", "0")), "planes[0].label"));
  EXPECT_TRUE(contains(message_for(plane("4294967296", "[0,0,1]", "2", "0")), "planes[0].label"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,2]", "2", "0")), "not of length 1"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,1]", "2", "0")), "list of 3 numbers"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "-2", "0")), "area is negative"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "1e300")), "not within 1e9"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "1e400")), "out of range"));
  EXPECT_TRUE(contains(message_for(plane("1", "[0,0,1]", "2", "null")), "is not a number"));
  EXPECT_TRUE(contains(message_for(std::string(100'000, '[')), "nested more than 64 deep"));
  EXPECT_THROW(read_true_planes(folder / "absent.json"), Error);
  EXPECT_THROW(read_true_planes(folder.path()), Error);
  EXPECT_THROW(write_truth({}, folder / "no such folder" / "t.json"), Error);
}

}  // namespace
}  // namespace planescope
