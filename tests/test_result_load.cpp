// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "fixtures.hpp"
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

}  // namespace
}  // namespace planescope
