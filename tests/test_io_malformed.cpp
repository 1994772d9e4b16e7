// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "malformed_rules.hpp"

/// \file The readers' contract: every rule is kept, and no spoilt byte crashes.
namespace planescope {
namespace {

using namespace std::string_literals;
using namespace testing;

class MalformedFiles : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedFiles, AreRefusedInOneLine) {
  const std::string message = refusal(GetParam().bytes);
  EXPECT_TRUE(message.starts_with("test: ")) << message;
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// Where a rule's bytes lie: tests/malformed/{pcd,ply}/GROUP_RULE.
std::filesystem::path file_of(const Malformed& rule) {
  const std::string suite =
      ::testing::UnitTest::GetInstance()->current_test_info()->test_suite_name();
  const char* folder = rule.bytes.starts_with("ply") ? "ply" : "pcd";
  return std::filesystem::path(PLANESCOPE_SOURCE_DIR) / "tests/malformed" / folder /
         (suite.substr(0, suite.find('/')) + "_" + rule.name);
}

/// PLANESCOPE_WRITE_MALFORMED=1 writes the files anew.
TEST_P(MalformedFiles, LieInTheFolder) {
  const auto file = file_of(GetParam());
  if (std::getenv("PLANESCOPE_WRITE_MALFORMED") != nullptr)
    std::ofstream(file, std::ios::binary) << GetParam().bytes;
  std::ifstream in(file, std::ios::binary);
  ASSERT_TRUE(in.is_open()) << file;
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(in), {}}), GetParam().bytes);
}

const auto kName = [](const auto& file) { return file.param.name; };
#define PLANESCOPE_RULES(group, rules) \
  INSTANTIATE_TEST_SUITE_P(group, MalformedFiles, ::testing::ValuesIn(rules()), kName)
PLANESCOPE_RULES(Magic, magic_rules);
PLANESCOPE_RULES(PcdHeader, pcd_header_rules);
PLANESCOPE_RULES(Fields, field_rules);
PLANESCOPE_RULES(PcdAscii, pcd_ascii_rules);
PLANESCOPE_RULES(PcdBinary, pcd_binary_rules);
PLANESCOPE_RULES(PcdCompressed, pcd_compressed_rules);
PLANESCOPE_RULES(PlyHeader, ply_header_rules);
PLANESCOPE_RULES(PlyData, ply_data_rules);

TEST(MalformedBase, TheFilesThatAreSpoiledAreGood) {
  EXPECT_EQ(refusal(pcd()), "");
  EXPECT_EQ(refusal(ply()), "");
  EXPECT_EQ(refusal(binary("1", kPoint)), "");
  EXPECT_EQ(refusal(compressed(13, 12, "\x0B"s + kPoint)), "");
}

TEST(MalformedLimits, MorePointsThanAllowed) {
  EXPECT_EQ(refusal(pcd(), {.max_points = 2}), "");
  EXPECT_NE(refusal(pcd(), {.max_points = 1}).find("2 points, the limit is 1"), std::string::npos);
  EXPECT_NE(refusal(ply(), {.max_points = 1}).find("2 points, the limit is 1"), std::string::npos);
}

TEST(MalformedSweep, EveryPrefixIsRefusedAndNoSpoiltByteCrashes) {
  const std::vector<std::string> files = {
      pcd(), ply(), binary("1", kPoint), compressed(13, 12, "\x0B"s + kPoint),
      ply_header("binary_big_endian",
                 "element face 1\nproperty list uchar int v\nelement vertex 1\n" + kXyz) +
          "\x01"s + big(7, 1.F, 2.F, 3.F)};
  std::mt19937_64 random(3);
  for (const std::string& file : files) {
    // Text cannot tell that its last digit is missing, or the line end after it.
    const bool text = file == pcd() || file == ply();
    for (std::size_t size = 0; size + (text ? 2 : 0) < file.size(); ++size) {
      EXPECT_NE(refusal(file.substr(0, size)), "") << size;
    }
    for (int trial = 0; trial < 2000; ++trial) {
      std::string spoilt = file;
      for (std::uint64_t k = random() % 4 + 1; k > 0; --k) {
        spoilt[random() % spoilt.size()] = static_cast<char>(random());
      }
      const std::string message = refusal(spoilt);  // taken or refused as input, nothing else
      EXPECT_EQ(message.find("not Kind::Input"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace planescope
