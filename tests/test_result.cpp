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

namespace planescope {
namespace {

using nlohmann::json;
using testing::read_bytes;
using testing::TemporaryFolder;
using testing::write_bytes;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Six points: three on a floor patch, two on a box patch, one without a return.
PointCloud small_cloud() {
  PointCloud cloud;
  cloud.positions = {{0, 0, 0},           {1, 0, 0},           {0, 1, 0},
                     {0.5f, 0.5f, 0.25f}, {0.1f, 0.5f, 0.25f}, {kNan, kNan, kNan}};
  cloud.colors = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}, {253, 254, 255}, {0, 0, 0}};
  cloud.labels = {1, 1, 1, 2, 2, 0};
  cloud.width = 3;
  cloud.height = 2;
  cloud.sensor = Eigen::Vector3f(0, 0, 2);
  return cloud;
}

/// What segment() could have made of it, by hand.
Segmentation small_scene() {
  Segmentation scene;
  scene.options = Options::tabletop();
  scene.graph.patches.resize(2);
  scene.graph.point_patch = {0, 0, 0, 1, 1, kNone};
  SupportingPlane floor;
  floor.patch_count = 1;
  floor.point_count = 3;
  floor.area = 0.1f;
  scene.planes = {floor};
  scene.patch_plane = {{0, 1.0f}, {kNone, 1.0f}};
  scene.selection.lambda = 2;
  scene.selection.proposed = 9;
  scene.selection.hypotheses.resize(3);
  for (PlaneHypothesis& h : scene.selection.hypotheses) h.inlier_count = 3;
  scene.selection.hypotheses[0].selected = true;
  scene.selection.hypotheses[1].blocked_by = 0;
  scene.selection.hypotheses[1].blocked_angle_cost = 0.75;
  scene.selection.hypotheses[2].inlier_count = 2;  // not more than lambda: not reported
  scene.selection.selected = {0};
  Edge edge;
  edge.second = 1;
  edge.rule = EdgeRule::PlaneBoundary;
  scene.edges = {edge};
  scene.segments.segments = {{1, 0, 1, 3, 0.1f, {0.5f, 0.5f, 0}},
                             {2, kNone, 1, 2, 0.05f, {0.3f, 0.5f, 0.25f}}};
  scene.segments.patch_label = {1, 2};
  scene.point_label = {1, 1, 1, 2, 2, kNoSegment};
  scene.point_plane = {0, 0, 0, kNone, kNone, kNone};
  return scene;
}

/// The message with which the folder is refused.
std::string refusal(const std::filesystem::path& folder) {
  try {
    load_result(folder);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    return error.what();
  }
  return {};
}

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

/// Each edit of result.json that load_result() must notice: a JSON pointer and its new value.
TEST(LoadResult, RefusesEveryEditThatMatters) {
  const std::vector<std::pair<std::string, json>> edits = {
      {"/schema", 99},
      {"/schema", nullptr},
      {"/method", 1},
      {"/method/name", 1},
      {"/method/lacks", json::array({"wheels"})},
      {"/method/settings", json::array()},
      {"/input", 1},
      {"/input/width", -3},
      {"/input/width", 4},
      {"/input/width", 3.5},
      {"/input/points", 5},
      {"/input/height", 4000000000u},
      {"/input/has_color", "yes"},
      {"/input/origin", json::array({1, 2})},
      {"/input/origin/0", 1e300},
      {"/options/patches.voxel_size", 0},
      {"/options", json::object()},
      {"/up", json::array({0, 0, 2})},
      {"/up/0", nullptr},
      {"/patches", 1},
      {"/planes", json::array()},
      {"/planes/0/id", 1},
      {"/planes/0/normal", json::array({1, 1, 1})},
      {"/planes/0/distance", "near"},
      {"/segments/0/label", 2},
      {"/segments/0/plane", 1},
      {"/segments/1/plane", -1},
      {"/segments", json::object()},
      {"/edges/by_rule/concave", -1},
      {"/edges/by_rule", nullptr},
      {"/points_hash", "0000000000000000"}};
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path());
  const json good = json::parse(read_bytes(folder / "result.json"));
  ASSERT_EQ(refusal(folder.path()), "");
  for (const auto& [pointer, value] : edits) {
    json bad = good;
    ASSERT_TRUE(bad.contains(json::json_pointer(pointer))) << pointer;
    bad[json::json_pointer(pointer)] = value;
    write_bytes(folder / "result.json", bad.dump());
    const std::string message = refusal(folder.path());
    EXPECT_NE(message, "") << pointer << " = " << value;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(LoadResult, RefusesPointsThatDoNotBelong) {
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path());
  const std::string points = read_bytes(folder / "points.pcd");
  const std::size_t data = points.find("DATA binary\n") + 12;
  const auto refused = [&](const std::string& bytes) {
    write_bytes(folder / "points.pcd", bytes);
    return refusal(folder.path()) != "";
  };
  EXPECT_FALSE(refused(points));
  EXPECT_TRUE(refused(points.substr(0, points.size() - 1)));
  EXPECT_TRUE(refused(points + "x"));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("x" + points.substr(1)));
  std::string moved = points;
  moved[data + 2] = 1;  // another coordinate: everything is in range, but the hash is another
  EXPECT_TRUE(refused(moved));
}

TEST(LoadResult, RefusesIndicesThatAreNotThere) {
  const TemporaryFolder folder;
  save(small_scene(), small_cloud(), folder.path());
  const std::string points = read_bytes(folder / "points.pcd");
  json all = json::parse(read_bytes(folder / "result.json"));
  const std::size_t data = points.find("DATA binary\n") + 12;
  for (const std::size_t column : {16u, 20u, 24u}) {  // label, plane, patch of the first point
    std::string bytes = points;
    bytes[data + column] = 3;
    write_bytes(folder / "points.pcd", bytes);
    all["points_hash"] = hash_file(folder / "points.pcd");  // whoever edits may know of the hash
    write_bytes(folder / "result.json", all.dump());
    EXPECT_NE(refusal(folder.path()).find("point 0 has a label"), std::string::npos) << column;
  }
  std::string labelled = points;
  labelled[data + 5 * 28 + 16] = 1;  // the point without a return
  write_bytes(folder / "points.pcd", labelled);
  all["points_hash"] = hash_file(folder / "points.pcd");
  write_bytes(folder / "result.json", all.dump());
  EXPECT_NE(refusal(folder.path()).find("point 5 has a label"), std::string::npos);
}

TEST(LoadResult, RefusesWhatIsMissingOrNotJson) {
  const TemporaryFolder folder;
  EXPECT_NE(refusal(folder / "nowhere").find("not a folder"), std::string::npos);
  EXPECT_NE(refusal(folder.path()).find("result.json"), std::string::npos);
  write_bytes(folder / "result.json", "{\"schema\": 1,");
  EXPECT_NE(refusal(folder.path()).find("byte 14"), std::string::npos);
  save(small_scene(), small_cloud(), folder.path());
  std::filesystem::remove(folder / "points.pcd");
  EXPECT_NE(refusal(folder.path()).find("points.pcd"), std::string::npos);
}

/// One step of FNV-1a, its prime 2^40 + 0x1b3 = 2^40 + 2^8 + 2^7 + 2^5 + 2^4 + 3 taken bit by bit.
std::uint64_t fnv(std::uint64_t state, std::uint64_t word) {
  const std::uint64_t x = state ^ word;
  return (x << 40) + (x << 8) + (x << 7) + (x << 5) + (x << 4) + x * 3;
}

TEST(HashFile, IsFnv1aInEightByteSteps) {
  const TemporaryFolder folder;
  const auto hash = [&](const std::string& bytes) {
    write_bytes(folder / "f", bytes);
    return hash_file(folder / "f");
  };
  const auto hex = [](std::uint64_t value) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
    return std::string(text);
  };
  EXPECT_EQ(hash(""), "cbf29ce484222325");   // FNV's offset basis
  EXPECT_EQ(hash("a"), "af63dc4c8601ec8c");  // published FNV-1a test vector
  EXPECT_EQ(hash("foobar"), "85944171f73967e8");
  const std::uint64_t word = 0x6867666564636261;  // "abcdefgh", little-endian
  EXPECT_EQ(hash("abcdefgh"), hex(fnv(0xcbf29ce484222325, word)));
  EXPECT_EQ(hash("abcdefgha"), hex(fnv(fnv(0xcbf29ce484222325, word), 'a')));
  EXPECT_NE(hash("a"), hash(std::string("a\0", 2)));
  EXPECT_THROW(hash_file(folder / "none"), Error);
}

TEST(HashFile, LongFilesAreReadInPieces) {
  const TemporaryFolder folder;
  std::string bytes((std::size_t{3} << 20) + 5, 'x');
  write_bytes(folder / "f", bytes);
  std::uint64_t state = 0xcbf29ce484222325;
  for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) state = fnv(state, 0x7878787878787878);
  for (int i = 0; i < 5; ++i) state = fnv(state, 'x');
  EXPECT_EQ(std::stoull(hash_file(folder / "f"), nullptr, 16), state);
}

}  // namespace
}  // namespace planescope
