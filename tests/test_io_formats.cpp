// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/lzf.hpp"
#include "io/numbers.hpp"
#include "io_bytes.hpp"

/// \file What files that others wrote mean: each written here byte by byte.
namespace planescope {
namespace {

using namespace std::string_literals;
using testing::big;
using testing::little;
using testing::pcd_header;
using testing::ply_header;
using testing::read;
using Vector = Eigen::Vector3f;

TEST(PcdAscii, FieldsInAnyOrderWithOthersBetween) {
  const PointCloud cloud = read(
      "# .PCD v.7 - Point Cloud Data file format\n\n# a comment\nVERSION .7\n"
      "FIELDS label intensity z y x histogram rgb _\nSIZE 1 4 4 8 4 2 4 1\nTYPE U F F F F I F U\n"
      "COUNT 1 1 1 1 1 3 1 2\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 0 1 0 0\nPOINTS 2\nDATA ascii\n"
      "7 0.5 3 2 1 9 9 9 4.2108e+06 0 0\n255 x -3e-1 +2.5 .125 9 9 9 2.35098856e-38 0 0\n");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.positions[0], Vector(1, 2, 3));
  EXPECT_EQ(cloud.positions[1], Vector(0.125F, 2.5F, -0.3F));
  EXPECT_EQ(cloud.labels, (std::vector<std::uint32_t>{7, 255}));
  // 4210800 = 0x4A808080 as float's bits, of which the low three bytes are the colour.
  EXPECT_EQ(cloud.colors[0], (Rgb{0x80, 0x80, 0xE0}));
  EXPECT_EQ(cloud.colors[1], (Rgb{0xFF, 0xFF, 0xFF}));  // 0x00FFFFFF
  EXPECT_FALSE(cloud.sensor);
}

TEST(PcdAscii, MissingNumbersAndLineEndsOfAllKinds) {
  const PointCloud cloud = read(
      "VERSION 0.7\r\nFIELDS x y z\r\nSIZE 4 4 4\r\nTYPE F F F\r\nWIDTH 5\r\nHEIGHT 1\r\n"
      "DATA ascii\r\n1 2 3\r\nnan NaN -nan\r\n\r\n \t \r\ninf -inf 0\r\n\t4  5\t6 \n1e-46 0 1");
  ASSERT_EQ(cloud.size(), 5U);
  EXPECT_TRUE(cloud.positions[1].array().isNaN().all());
  EXPECT_EQ(cloud.positions[2].x(), std::numeric_limits<float>::infinity());
  EXPECT_EQ(cloud.positions[3], Vector(4, 5, 6));
  EXPECT_EQ(cloud.positions[4], Vector(0, 0, 1));
}

TEST(PcdAscii, PointsAloneAndColumnsAsInOldFiles) {
  const PointCloud cloud = read(
      "# .PCD v.5\nVERSION .5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA ascii\n"
      "1 2 3\n4 5 6\n");
  EXPECT_EQ(cloud.width, 2U);
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud.positions[1], Vector(4, 5, 6));
}

TEST(PcdBinary, EveryLabelTypeAndExtraBytesAtTheEnd) {
  const auto label = [](const std::string& size, const std::string& type,
                        const std::string& bytes) {
    return read(pcd_header("x y z label", "4 4 4 " + size, "F F F " + type, 1, "binary") +
                little(1.F, 2.F, 3.F) + bytes + "more bytes")
        .labels.at(0);
  };
  EXPECT_EQ(label("1", "U", little(std::uint8_t{200})), 200U);
  EXPECT_EQ(label("1", "I", little(std::int8_t{100})), 100U);
  EXPECT_EQ(label("2", "U", little(std::uint16_t{60000})), 60000U);
  EXPECT_EQ(label("2", "I", little(std::int16_t{30000})), 30000U);
  EXPECT_EQ(label("4", "U", little(std::uint32_t{4294967295})), 4294967295U);
  EXPECT_EQ(label("4", "I", little(std::int32_t{2147483647})), 2147483647U);
  EXPECT_EQ(label("8", "U", little(std::uint64_t{4294967295})), 4294967295U);
  EXPECT_EQ(label("8", "I", little(std::int64_t{5})), 5U);
  EXPECT_EQ(label("4", "F", little(12.F)), 12U);
}

TEST(PcdBinary, ColourIsTheLowThreeBytesWhateverItsType) {
  for (const std::string field : {"rgb", "rgba"}) {
    for (const std::string type : {"F", "U", "I"}) {
      // Alpha 255 makes the bits a NaN where they are taken for a float.
      const PointCloud cloud =
          read(pcd_header("x y z " + field, "4 4 4 4", "F F F " + type, 1, "binary") +
               little(1.F, 2.F, 3.F, std::uint32_t{0xFFC08040}));
      EXPECT_EQ(cloud.colors.at(0), (Rgb{0xC0, 0x80, 0x40})) << field << type;
    }
  }
}

TEST(PcdBinary, NormalsAreMadeUnit) {
  const PointCloud cloud = read(
      pcd_header("x y z normal_x normal_y normal_z", "4 4 4 4 4 4", "F F F F F F", 4, "binary") +
      little(0.F, 0.F, 0.F, 0.F, 3.F, 4.F) + little(0.F, 0.F, 0.F, 0.F, 0.F, 0.F) +
      little(0.F, 0.F, 0.F, 0.6F, 0.F, -0.8F) + little(0.F, 0.F, 0.F, NAN, 0.F, 1.F));
  EXPECT_TRUE(cloud.normals[0].isApprox(Vector(0, 0.6F, 0.8F)));
  EXPECT_TRUE(cloud.normals[1].array().isNaN().all());
  EXPECT_EQ(cloud.normals[2], Vector(0.6F, 0, -0.8F));
  EXPECT_TRUE(cloud.normals[3].array().isNaN().all());
}

TEST(PcdBinary, ShapeAndSensor) {
  const auto view = [](int width, int height, const std::string& viewpoint) {
    std::string points;
    for (int i = 0; i < width * height; ++i) points += little(static_cast<float>(i), 0.F, 1.F);
    return read("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH " + std::to_string(width) +
                "\nHEIGHT " + std::to_string(height) + "\n" + viewpoint + "DATA binary\n" + points);
  };
  const PointCloud image = view(3, 2, "");
  EXPECT_EQ(image.width, 3U);
  EXPECT_EQ(image.height, 2U);
  EXPECT_EQ(image.sensor.value(), Vector(0, 0, 0));
  EXPECT_EQ(view(3, 2, "VIEWPOINT 1 2.5 -3 0 1 0 0\n").sensor.value(), Vector(1, 2.5F, -3));
  EXPECT_FALSE(view(6, 1, "VIEWPOINT 0 0 0 1 0 0 0\n").sensor);
  EXPECT_EQ(view(6, 1, "VIEWPOINT 0 0 2 1 0 0 0\n").sensor.value(), Vector(0, 0, 2));
  const PointCloud column = view(1, 6, "");  // nothing is next to anything: a list
  EXPECT_EQ(column.width, 6U);
  EXPECT_EQ(column.height, 1U);
  EXPECT_FALSE(column.sensor);
}

TEST(PcdCompressed, FieldsOneAfterTheOther) {
  // x 1 1 1, y 2 2 2, z 0 0 0, rgba of three points: each once, then copied from 4 bytes back.
  const auto repeated = [](const std::string& number) {
    return "\x03"s + number + "\xC0\x03"s;  // 4 literals; LLL = 6 copies 8 bytes, distance 3 + 1
  };
  const std::string zeros = "\x00\x00"s + "\xE0\x02\x00"s;  // 1 literal; 2 + 9 bytes, distance 1
  const std::string stream = repeated(little(1.F)) + repeated(little(2.F)) + zeros +
                             repeated(little(std::uint32_t{0x00102030}));
  const PointCloud cloud =
      read(pcd_header("x y z rgba", "4 4 4 4", "F F F U", 3, "binary_compressed") +
           little(static_cast<std::uint32_t>(stream.size()), std::uint32_t{48}) + stream);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cloud.positions[i], Vector(1, 2, 0));
    EXPECT_EQ(cloud.colors[i], (Rgb{0x10, 0x20, 0x30}));
  }
}

TEST(Lzf, CopiesThatReachFarAndThatOverlap) {
  std::string input, expected;
  for (int i = 0; i < 8192; i += 32) {  // 32 literals at a time
    std::string run;
    for (int k = 0; k < 32; ++k) run += static_cast<char>((i * 7 + k * k) & 255);
    input += '\x1F' + run;
    expected += run;
  }
  input += "\x3F\xFF"s;  // LLL = 1: 3 bytes from 8192 back, the furthest
  expected += expected.substr(0, 3);
  input += "\xE0\xFF\x01"s;  // 264 bytes from 2 back, the longest
  for (int k = 0; k < 264; ++k) expected += expected[expected.size() - 2];
  std::string output(expected.size(), '?');
  const auto failure =
      io::lzf_expand(std::as_bytes(std::span(input)), std::as_writable_bytes(std::span(output)));
  EXPECT_FALSE(failure) << failure->what;
  EXPECT_EQ(output, expected);
}

TEST(PlyAscii, ListsOtherElementsAndComments) {
  const PointCloud cloud = read(
      "ply\r\ncomment made by hand\r\nformat ascii 1.0\r\nobj_info nothing\r\n"
      "element camera 1\r\nproperty float a\r\nelement face 2\r\n"
      "property list uchar int vertex_indices\r\nelement vertex 2\r\nproperty float32 z\r\n"
      "property list uint8 int16 tags\r\nproperty float64 y\r\nproperty float x\r\n"
      "property uchar blue\r\nproperty uint8 red\r\nproperty uchar green\r\n"
      "property float nz\r\nproperty float ny\r\nproperty float nx\r\nproperty int label\r\n"
      "element edge 1\r\nproperty int v\r\nend_header\r\n"
      "1.5\r\n3 0 1 2\r\n0\r\n3 2 8 9 2 1 30 10 20 1 0 0 5\r\n6 0 5 4 3 2 1 1 0 0 6\r\nwhatever");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.positions[0], Vector(1, 2, 3));
  EXPECT_EQ(cloud.positions[1], Vector(4, 5, 6));
  EXPECT_EQ(cloud.colors[0], (Rgb{10, 20, 30}));
  EXPECT_EQ(cloud.normals[0], Vector(0, 0, 1));
  EXPECT_EQ(cloud.normals[1], Vector(0, 0, 1));
  EXPECT_EQ(cloud.labels, (std::vector<std::uint32_t>{5, 6}));
  EXPECT_FALSE(cloud.sensor);
}

TEST(PlyBinary, AllTypesInBothByteOrders) {
  const std::string header =
      "element face 1\nproperty list ushort double d\nproperty char a\n"
      "element vertex 2\nproperty char a\nproperty uchar b\nproperty short c\nproperty ushort d\n"
      "property int e\nproperty uint label\nproperty float x\nproperty double y\nproperty float z\n"
      "property list int float skipped\nproperty ushort red\nproperty ushort green\n"
      "property ushort blue\nelement end 9\nproperty float q\n";
  const auto body = [](auto bytes) {
    std::string data = bytes(std::uint16_t{2}, 1.0, 2.0, std::int8_t{1});
    for (const float k : {0.F, 10.F}) {
      data += bytes(std::int8_t{-1}, std::uint8_t{1}, std::int16_t{-2}, std::uint16_t{2},
                    std::int32_t{-3}, std::uint32_t{70000}, 1.F + k, 2.5 + double{k}, 3.F + k);
      data += k == 0.F ? bytes(std::int32_t{0}) : bytes(std::int32_t{2}, 1.F, 2.F);
      data += bytes(std::uint16_t{65535}, std::uint16_t{0}, std::uint16_t{257 * 9});
    }
    return data;
  };
  const std::string small = body([](auto... v) { return little(v...); });
  const std::string large = body([](auto... v) { return big(v...); });
  for (const PointCloud& cloud : {read(ply_header("binary_little_endian", header) + small),
                                  read(ply_header("binary_big_endian", header) + large)}) {
    ASSERT_EQ(cloud.size(), 2U);
    EXPECT_EQ(cloud.positions[0], Vector(1, 2.5F, 3));
    EXPECT_EQ(cloud.positions[1], Vector(11, 12.5F, 13));
    EXPECT_EQ(cloud.labels[1], 70000U);
    EXPECT_EQ(cloud.colors[1], (Rgb{255, 0, 9}));
  }
}

TEST(PlyBinary, FixedRecordsInBothByteOrders) {
  const std::string header =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty float red\n"
      "property float green\nproperty float blue\n";
  const std::string small =
      ply_header("binary_little_endian", header) + little(1.F, 2.F, 3.F, 0.F, 0.5F, 1.F);
  const std::string large =
      ply_header("binary_big_endian", header) + big(1.F, 2.F, 3.F, -0.5F, 0.5F, 2.F);
  for (const PointCloud& cloud : {read(small), read(large)}) {
    EXPECT_EQ(cloud.positions.at(0), Vector(1, 2, 3));
    EXPECT_EQ(cloud.colors.at(0), (Rgb{0, 128, 255}));
  }
}

/// A cloud of doubles around `centre`, with one point far off.
std::string far_cloud(const Eigen::Vector3d& centre, double outlier) {
  std::string points = little(outlier, outlier, outlier);
  for (int i = 0; i < 999; ++i) {
    points += little(centre.x() + i * 0.001, centre.y() - i * 0.001, centre.z() + 0.25);
  }
  return pcd_header("x y z", "8 8 8", "F F F", 1000, "binary") + points;
}

TEST(Origin, FarCloudIsShiftedByWholeMetresWhateverTheOutlier) {
  for (const double outlier : {1e9, -1e9, 1e300, 0.0}) {
    const PointCloud cloud = read(far_cloud({1e6, -2e6, 30}, outlier));
    EXPECT_EQ(cloud.origin, cloud.origin.array().round().matrix());
    EXPECT_LT((cloud.origin - Eigen::Vector3d(1e6, -2e6, 30)).norm(), 2);
    for (int i = 0; i < 999; ++i) {  // a float of 1e6 m would be off by up to 3 cm
      const Eigen::Vector3d world =
          cloud.origin + cloud.positions[static_cast<std::size_t>(i) + 1].cast<double>();
      EXPECT_LT((world - Eigen::Vector3d(1e6 + i * 0.001, -2e6 - i * 0.001, 30.25)).norm(), 1e-6);
    }
  }
}

TEST(Origin, NearCloudIsNotShifted) {
  EXPECT_TRUE(read(far_cloud({900, -900, 0}, 1e9)).origin.isZero(0));
  EXPECT_FALSE(read(far_cloud({0, 0, 1100}, 0)).origin.isZero(0));
}

TEST(Origin, IsFoundWhereTheSampleHasNoReturn) {
  std::string points;
  for (int i = 0; i < 200'000; ++i) {
    points += i == 150'001 ? little(5000.5F, 1.F, 2.F) : little(NAN, NAN, NAN);
  }
  const PointCloud cloud = read(pcd_header("x y z", "4 4 4", "F F F", 200'000, "binary") + points);
  EXPECT_EQ(cloud.origin, Eigen::Vector3d(5001, 1, 2));
  EXPECT_EQ(cloud.positions[150'001], Vector(-0.5F, 0, 0));
}

TEST(Origin, ShiftedImageWithoutViewpointHasNoSensor) {
  const std::string image =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 2\n"s + "VIEWPOINT ";
  const std::string data = "DATA ascii\n3000 0 0\n3000 0 0\n3000 0 0\n3000 0 0\n";
  EXPECT_FALSE(read(image + "0 0 0 1 0 0 0\n" + data).sensor);
  EXPECT_EQ(read(image + "3001 0 1 1 0 0 0\n" + data).sensor.value(), Vector(1, 0, 1));
}

TEST(Numbers, WholeWordsOnly) {
  using io::parse_word;
  EXPECT_EQ(parse_word<std::uint64_t>("18446744073709551615"), 18446744073709551615U);
  EXPECT_EQ(parse_word<std::int8_t>("-128"), -128);
  EXPECT_EQ(parse_word<double>("-.5e-3"), -0.0005);
  EXPECT_EQ(parse_word<float>("+1.5"), 1.5F);
  EXPECT_TRUE(std::signbit(parse_word<float>("-1e-50").value()));
  for (const char* word :
       {"", "-1", "+1", "1.0", "0x1", "18446744073709551616", "1 ", " 1", "1a"}) {
    EXPECT_FALSE(parse_word<std::uint64_t>(word)) << word;
  }
  for (const char* word :
       {"", "1,5", "1e", "--1", "+-1", "+", "1e39", "-1e39", "1f", "none", "0x1p3"}) {
    EXPECT_FALSE(parse_word<float>(word)) << word;
  }
}

}  // namespace
}  // namespace planescope
