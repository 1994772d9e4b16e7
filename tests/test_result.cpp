// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/result.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "fixtures.hpp"
#include "planescope/error.hpp"
#include "result_fixtures.hpp"

namespace planescope {
namespace {

using nlohmann::json;
using testing::read_bytes;
using testing::refusal;
using testing::small_cloud;
using testing::small_scene;
using testing::TemporaryFolder;
using testing::write_bytes;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

bool same_bits(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(float)) == 0;
}

TEST(Result, ComesBackFromItsFolder) {
  const TemporaryFolder folder;
  const PointCloud cloud = small_cloud();
  const Segmentation scene = small_scene();
  save(scene, cloud, folder / "a", {"room.pcd", "0123"});
  const Result made = make_result(scene, cloud, {"room.pcd", "0123"});
  const Result loaded = load_result(folder / "a");
  ASSERT_EQ(loaded.cloud.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(same_bits(loaded.cloud.positions[i], cloud.positions[i])) << i;
  }
  EXPECT_EQ(loaded.cloud.colors, cloud.colors);
  EXPECT_EQ(loaded.cloud.width, 3u);
  EXPECT_EQ(loaded.cloud.height, 2u);
  EXPECT_EQ(loaded.cloud.sensor, cloud.sensor);
  EXPECT_EQ(loaded.point_label, scene.point_label);
  EXPECT_EQ(loaded.point_plane, scene.point_plane);
  EXPECT_EQ(loaded.point_patch, scene.graph.point_patch);
  EXPECT_EQ(loaded.rule_counts, made.rule_counts);
  EXPECT_EQ(loaded.rule_counts[2], 1u);  // plane_boundary
  EXPECT_EQ(loaded.planes.size(), 1u);
  EXPECT_EQ(loaded.planes[0].area, 0.1f);
  EXPECT_EQ(loaded.segments.size(), 2u);
  EXPECT_EQ(loaded.segments[0].plane, 0);
  EXPECT_EQ(loaded.segments[1].plane, kNone);
  EXPECT_EQ(loaded.segments[0].centroid, scene.segments.segments[0].centroid);
  EXPECT_EQ(loaded.up, made.up);
  EXPECT_EQ(loaded.patch_count, 2u);
  EXPECT_EQ(loaded.input_name, "room.pcd");
  EXPECT_EQ(loaded.voxel_size, 0.0075);
  EXPECT_EQ(loaded.patch_size, 0.03);
  EXPECT_TRUE(loaded.has_colors);
  EXPECT_TRUE(made.cloud.labels.empty()) << "truth is no part of a result";
}

TEST(Result, SaysWhichPeerMadeItAndWhatThatLacks) {
  const TemporaryFolder folder;
  Segmentation scene = small_scene();
  EXPECT_TRUE(
      (save(scene, small_cloud(), folder / "a"), load_result(folder / "a").method.is_ours()));
  scene.method = {"lccp", false, true, {{"lccp.voxel_size", 0.5}}};
  save(scene, small_cloud(), folder / "b");
  const MethodInfo method = load_result(folder / "b").method;
  EXPECT_EQ(method.name, "lccp");
  EXPECT_FALSE(method.has_planes);
  EXPECT_TRUE(method.has_graph);
  EXPECT_EQ(method.settings, scene.method.settings);
  const json all = json::parse(read_bytes(folder / "b" / "result.json"));
  EXPECT_EQ(all["method"]["lacks"], json::array({"planes"}));
  EXPECT_EQ(all["options"].size(), 2U) << "of ours only the scale";
}

TEST(Result, JsonSaysWhatTheSceneHolds) {
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path(), {"room.pcd", "0123"});
  const json all = json::parse(read_bytes(folder / "result.json"));
  EXPECT_EQ(all["schema"], kResultSchema);
  EXPECT_EQ(all["input"]["points"], 6);
  EXPECT_EQ(all["input"]["finite_points"], 5);
  EXPECT_EQ(all["input"]["hash"], "0123");
  EXPECT_EQ(all["options"].size(), option_table().size());
  EXPECT_EQ(all["options"]["planes.sigma"], 0.01);
  EXPECT_EQ(all["options"]["planes.solver"], "lsa_tr+tabu");
  EXPECT_EQ(all["options"]["edges.extended_convexity"], false);
  EXPECT_EQ(all["planes"][0]["area"], 0.1) << "a float keeps its shortest text";
  EXPECT_EQ(all["hypotheses"]["proposed"], 9);
  ASSERT_EQ(all["hypotheses"]["rejected"].size(), 1u);
  EXPECT_EQ(all["hypotheses"]["rejected"][0]["blocked_by"], 0);
  EXPECT_EQ(all["hypotheses"]["rejected"][0]["angle_cost"], 0.75);
  EXPECT_EQ(all["segments"][1]["plane"], nullptr);
  EXPECT_EQ(all["edges"]["count"], 1);
  EXPECT_EQ(all["edges"]["off"], 1);
  EXPECT_EQ(all["edges"]["by_rule"]["plane_boundary"], 1);
  EXPECT_EQ(all["edges"]["by_rule"].size(), kEdgeRuleCount);
  EXPECT_EQ(all["points_hash"], hash_file(folder / "points.pcd"));
}

TEST(Result, OptionsInTheJsonMakeTheSameOptions) {
  const TemporaryFolder folder;
  Segmentation scene = small_scene();
  scene.options.planes.random_seed = std::numeric_limits<std::uint64_t>::max();
  scene.options.planes.alpha = 0.1 + 0.2;
  save(scene, small_cloud(), folder.path());
  const json all = json::parse(read_bytes(folder / "result.json"));
  Options copy;
  for (const auto& [key, value] : all["options"].items()) {
    set_option(copy, key, value.is_string() ? value.get<std::string>() : value.dump());
  }
  for (const OptionInfo& info : option_table()) {
    EXPECT_EQ(get_option(copy, info.name), get_option(scene.options, info.name)) << info.name;
  }
}

TEST(Result, SameSceneSameBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b"}) save(small_scene(), small_cloud(), folder / name, {"x", "y"});
  EXPECT_EQ(read_bytes(folder / "a" / "result.json"), read_bytes(folder / "b" / "result.json"));
  EXPECT_EQ(read_bytes(folder / "a" / "points.pcd"), read_bytes(folder / "b" / "points.pcd"));
}

TEST(Result, PointsFileIsPlainBinaryPcd) {
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path());
  const std::string bytes = read_bytes(folder / "points.pcd");
  const std::size_t data = bytes.find("DATA binary\n") + 12;
  EXPECT_NE(bytes.find("\nFIELDS x y z rgb label plane patch\nSIZE 4 4 4 4 4 4 4\n"
                       "TYPE F F F F U I I\nCOUNT 1 1 1 1 1 1 1\nWIDTH 3\nHEIGHT 2\n"),
            std::string::npos);
  ASSERT_EQ(bytes.size(), data + 6 * 28);
  // Point 3, byte by byte: 0.5f is 00 00 00 3f, 0.25f 00 00 80 3e; colour 0x00fafbfc; 2, -1, 1.
  const std::string point(
      "\0\0\0\x3f\0\0\0\x3f\0\0\x80\x3e\xfc\xfb\xfa\0\2\0\0\0\xff\xff\xff\xff\1\0\0\0", 28);
  EXPECT_EQ(bytes.substr(data + 3 * 28, 28), point);
}

TEST(Result, MapCoordinatesStayExact) {
  const TemporaryFolder folder;
  PointCloud cloud = small_cloud();
  cloud.origin = {691000, 5334000, 500};
  save(small_scene(), cloud, folder.path());
  EXPECT_NE(read_bytes(folder / "points.pcd").find("SIZE 8 8 8 4 4 4 4"), std::string::npos);
  const Result loaded = load_result(folder.path());
  EXPECT_EQ(loaded.cloud.origin, cloud.origin);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(loaded.cloud.positions[i], cloud.positions[i]) << i;
  }
  EXPECT_FALSE(is_finite(loaded.cloud.positions[5]));
}

TEST(Result, WithoutColorsThereAreNone) {
  const TemporaryFolder folder;
  PointCloud cloud = small_cloud();
  cloud.colors.clear();
  save(small_scene(), cloud, folder.path());
  const Result loaded = load_result(folder.path());
  EXPECT_FALSE(loaded.has_colors);
  EXPECT_TRUE(loaded.cloud.colors.empty());
}

TEST(Result, AFileNameNeedNotBeUtf8) {
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path(), {"r\xff\"oom\n.pcd", "0"});
  EXPECT_EQ(load_result(folder.path()).input_name, "r\xEF\xBF\xBD\"oom\n.pcd");
}

TEST(Result, AFolderThatIsAFileIsRefused) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", "x");
  EXPECT_THROW(save(small_scene(), small_cloud(), folder / "file"), Error);
  EXPECT_EQ(read_bytes(folder / "file"), "x");
  EXPECT_NE(refusal(folder / "file").find("not a folder"), std::string::npos);
}

}  // namespace
}  // namespace planescope
