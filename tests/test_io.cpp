// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <limits>
#include <random>

#include "fixtures.hpp"
#include "io/pcd_reader.hpp"
#include "io/pcd_writer.hpp"
#include "io_bytes.hpp"
#include "planescope/error.hpp"
#include "planescope/io.hpp"

namespace planescope {
namespace {

using testing::TemporaryFolder;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Points of every magnitude that float has, some of them missing, with all that a cloud can carry.
PointCloud random_cloud(std::size_t points) {
  std::mt19937_64 random(7);
  const auto real = [&] { return static_cast<float>(random() >> 40) / 8388608.F - 1; };
  PointCloud cloud;
  for (std::size_t i = 0; i < points; ++i) {
    const float scale = std::ldexp(1.F, static_cast<int>(random() % 60) - 50);
    cloud.positions.emplace_back(real() * scale, real() * scale, real() * scale);
    if (i % 7 == 3) cloud.positions.back().setConstant(kNan);
    if (i % 11 == 5) cloud.positions.back().y() = -0.F;
    cloud.colors.push_back({static_cast<std::uint8_t>(random()),
                            static_cast<std::uint8_t>(random()),
                            static_cast<std::uint8_t>(random())});
    Eigen::Vector3f normal(real(), real(), real() + 2);
    cloud.normals.push_back(normal.normalized());
    if (i % 13 == 1) cloud.normals.back().setConstant(kNan);
    cloud.labels.push_back(static_cast<std::uint32_t>(random()));
  }
  cloud.width = static_cast<std::uint32_t>(points);
  return cloud;
}

::testing::AssertionResult same_bits(const std::vector<Eigen::Vector3f>& a,
                                     const std::vector<Eigen::Vector3f>& b) {
  if (a.size() != b.size()) return ::testing::AssertionFailure() << a.size() << " " << b.size();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (std::isnan(a[i][k]) && std::isnan(b[i][k])) continue;
      if (std::bit_cast<std::uint32_t>(a[i][k]) == std::bit_cast<std::uint32_t>(b[i][k])) continue;
      return ::testing::AssertionFailure() << "point " << i << ": " << a[i][k] << " " << b[i][k];
    }
  }
  return ::testing::AssertionSuccess();
}

struct Layout {
  const char* extension;
  CloudEncoding encoding;
};

class RoundTrip : public ::testing::TestWithParam<Layout> {
 protected:
  PointCloud through(const PointCloud& cloud) {
    const auto file = folder_ / (std::string("cloud.") + GetParam().extension);
    write_cloud(cloud, file, GetParam().encoding);
    return read_cloud(file);
  }
  TemporaryFolder folder_;
};

TEST_P(RoundTrip, KeepsEveryBit) {
  // More than one block and more than one piece of text, the last ones partly filled.
  const PointCloud cloud = random_cloud(50'003);
  const PointCloud back = through(cloud);
  EXPECT_TRUE(same_bits(back.positions, cloud.positions));
  EXPECT_TRUE(same_bits(back.normals, cloud.normals));
  EXPECT_EQ(back.colors, cloud.colors);
  EXPECT_EQ(back.labels, cloud.labels);
  EXPECT_TRUE(back.origin.isZero(0));
  EXPECT_EQ(back.width, 50'003U);
  EXPECT_EQ(back.height, 1U);
  EXPECT_FALSE(back.sensor);
}

TEST_P(RoundTrip, KeepsWhatIsNotThereAway) {
  PointCloud cloud;
  cloud.positions = {{1, 2, 3}};
  const PointCloud back = through(cloud);
  EXPECT_TRUE(same_bits(back.positions, cloud.positions));
  EXPECT_FALSE(back.has_colors() || back.has_normals() || back.has_labels());
  EXPECT_EQ(back.width, 1U);
}

TEST_P(RoundTrip, ShiftedCloudKeepsItsOrigin) {
  PointCloud cloud;
  cloud.origin = {500'000, 4'000'000, -2'000};
  for (int i = 0; i < 1000; ++i) {
    const auto f = static_cast<float>(i);
    cloud.positions.emplace_back(f * 0.01F - 5.2F, 3.3F - f * 0.007F, f * 0.003F - 1.4F);
  }
  const PointCloud back = through(cloud);
  EXPECT_EQ(back.origin, cloud.origin);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    // 2^-30 is half the spacing of doubles at 4e6; float adds its own half at 5.
    EXPECT_LT((back.positions[i] - cloud.positions[i]).cwiseAbs().maxCoeff(), 2.4e-7) << i;
  }
}

TEST_P(RoundTrip, SameBytesTwice) {
  const PointCloud cloud = random_cloud(30'000);
  const std::string name = std::string("a.") + GetParam().extension;
  write_cloud(cloud, folder_ / name, GetParam().encoding);
  const std::string first = testing::read_bytes(folder_ / name);
  write_cloud(read_cloud(folder_ / name), folder_ / name, GetParam().encoding);
  EXPECT_EQ(testing::read_bytes(folder_ / name), first);
}

INSTANTIATE_TEST_SUITE_P(
    Io, RoundTrip,
    ::testing::Values(Layout{"pcd", CloudEncoding::Ascii}, Layout{"pcd", CloudEncoding::Binary},
                      Layout{"ply", CloudEncoding::Ascii}, Layout{"PLY", CloudEncoding::Binary}),
    [](const auto& layout) {
      return std::string(layout.param.extension) +
             (layout.param.encoding == CloudEncoding::Ascii ? "Ascii" : "Binary");
    });

TEST(IoPcd, OrganisedCloudKeepsShapeAndSensor) {
  const TemporaryFolder folder;
  for (const CloudEncoding encoding : {CloudEncoding::Ascii, CloudEncoding::Binary}) {
    PointCloud cloud = random_cloud(12);
    cloud.width = 4;
    cloud.height = 3;
    cloud.sensor = Eigen::Vector3f(0.1F, -0.25F, 1.7F);
    write_cloud(cloud, folder / "view.pcd", encoding);
    const PointCloud back = read_cloud(folder / "view.pcd");
    EXPECT_EQ(back.width, 4U);
    EXPECT_EQ(back.height, 3U);
    ASSERT_TRUE(back.sensor);
    EXPECT_EQ(*back.sensor, *cloud.sensor);
  }
}

TEST(IoPcd, ExtraColumnsComeBack) {
  const TemporaryFolder folder;
  const PointCloud cloud = random_cloud(5);
  const std::vector<std::int32_t> plane = {-1, 0, 7, std::numeric_limits<std::int32_t>::min(), 2};
  const std::vector<std::uint32_t> patch = {4, 3, 2, 1, 0};
  for (const CloudEncoding encoding : {CloudEncoding::Ascii, CloudEncoding::Binary}) {
    io::write_pcd(folder / "points.pcd", cloud, encoding,
                  {{"plane", std::span<const std::int32_t>(plane)},
                   {"patch", std::span<const std::uint32_t>(patch)}});
    const auto back = io::read_pcd_columns(folder / "points.pcd", {"patch", "plane"});
    EXPECT_EQ(back.cloud.labels, cloud.labels);
    ASSERT_EQ(back.extra.size(), 2U);
    EXPECT_EQ(back.extra[0], (std::vector<std::int32_t>{4, 3, 2, 1, 0}));
    EXPECT_EQ(back.extra[1], plane);
    EXPECT_TRUE(same_bits(read_cloud(folder / "points.pcd").positions, cloud.positions));
    EXPECT_THROW(io::read_pcd_columns(folder / "points.pcd", {"segment"}), Error);
    EXPECT_THROW(io::read_pcd_columns(folder / "points.pcd", {"x"}), Error);
  }
}

TEST(IoPcd, ExtraColumnBeyond32BitsIsRefused) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "a.pcd",
                       testing::pcd_header("x y z plane", "4 4 4 8", "F F F U", 2, "ascii") +
                           "0 0 0 2147483647\n0 0 0 2147483648\n");
  try {
    io::read_pcd_columns(folder / "a.pcd", {"plane"});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point 1"), std::string::npos) << error.what();
  }
}

TEST(IoPcd, GivenOriginIsApplied) {
  const TemporaryFolder folder;
  testing::write_bytes(
      folder / "a.pcd",
      testing::pcd_header("x y z", "8 8 8", "F F F", 1, "ascii") + "5000.25 6000 7000\n");
  const auto [cloud, extra] =
      io::read_pcd_columns(folder / "a.pcd", {}, Eigen::Vector3d(5001, 6000, 7000));
  EXPECT_EQ(cloud.positions[0], Eigen::Vector3f(-0.75F, 0, 0));
  EXPECT_EQ(cloud.origin, Eigen::Vector3d(5001, 6000, 7000));
}

TEST(IoWrite, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  const auto kind = [&](const PointCloud& cloud, const std::filesystem::path& file) {
    try {
      write_cloud(cloud, file);
    } catch (const Error& error) {
      return error.exit_code();
    }
    return 0;
  };
  PointCloud cloud = random_cloud(4);
  EXPECT_EQ(kind(cloud, folder / "a.xyz"), 3);
  EXPECT_EQ(kind(cloud, folder / "a"), 3);
  EXPECT_EQ(kind(cloud, folder / "no/a.pcd"), 3);
  EXPECT_EQ(kind(PointCloud{}, folder / "a.pcd"), 2);
  PointCloud shape = cloud;
  shape.width = 3;
  shape.height = 2;
  EXPECT_EQ(kind(shape, folder / "a.pcd"), 2);
  PointCloud colors = cloud;
  colors.colors.pop_back();
  EXPECT_EQ(kind(colors, folder / "a.ply"), 2);
  PointCloud labels = cloud;
  labels.labels.push_back(1);
  EXPECT_EQ(kind(labels, folder / "a.ply"), 2);
  const std::vector<std::int32_t> three(3);
  EXPECT_THROW(io::write_pcd(folder / "a.pcd", cloud, CloudEncoding::Binary,
                             {{"plane", std::span<const std::int32_t>(three)}}),
               Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));  // nothing half-written stays
}

/// Files may not grow beyond a size while this lives: write() then fails as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(IoWrite, FailureLeavesNothingBehind) {
  const TemporaryFolder folder;
  const PointCloud cloud = random_cloud(50'000);
  for (const CloudEncoding encoding : {CloudEncoding::Ascii, CloudEncoding::Binary}) {
    std::string message;
    {
      const SmallDisk disk(100'000);
      try {
        write_cloud(cloud, folder / "a.pcd", encoding);
      } catch (const Error& error) {
        message = error.what();
      }
    }
    EXPECT_NE(message.find("a.pcd: cannot be written"), std::string::npos) << message;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
  std::filesystem::create_directory(folder / "folder.pcd");  // what cannot be put in place
  EXPECT_THROW(write_cloud(cloud, folder / "folder.pcd"), Error);
  std::filesystem::remove(folder / "folder.pcd");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(IoWrite, ReplacesAFileOnlyWhenWhole) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "a.ply", "before");
  {
    const SmallDisk disk(100'000);
    EXPECT_THROW(write_cloud(random_cloud(50'000), folder / "a.ply"), Error);
  }
  EXPECT_EQ(testing::read_bytes(folder / "a.ply"), "before");
}

TEST(IoRead, FilesThatAreNone) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "empty.pcd", "");
  for (const std::string name : {"missing.pcd", "empty.pcd", ""}) {
    try {
      read_cloud(folder / name);
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), 3);
      EXPECT_NE(std::string(error.what()).find(folder.path().string()), std::string::npos);
    }
  }
}

struct RealFile {
  const char* name;
  std::uint32_t width, height;
  std::size_t finite;  ///< as PCL 1.13's readers count them too
  bool colors, labels;
};

class RealFiles : public ::testing::TestWithParam<RealFile> {};

TEST_P(RealFiles, AreReadWhole) {
  const RealFile& expected = GetParam();
  const auto file = testing::shared_data(expected.name);
  if (file.empty()) GTEST_SKIP() << testing::missing(expected.name);
  const PointCloud cloud = read_cloud(file);
  EXPECT_EQ(cloud.width, expected.width);
  EXPECT_EQ(cloud.height, expected.height);
  EXPECT_EQ(cloud.size(), std::size_t{expected.width} * expected.height);
  std::size_t finite = 0;
  for (const Eigen::Vector3f& p : cloud.positions) finite += is_finite(p) ? 1 : 0;
  EXPECT_EQ(finite, expected.finite);
  EXPECT_EQ(cloud.has_colors(), expected.colors);
  EXPECT_EQ(cloud.has_labels(), expected.labels);
  EXPECT_EQ(cloud.sensor.has_value(), expected.height > 1);
}

INSTANTIATE_TEST_SUITE_P(
    Io, RealFiles,
    ::testing::Values(RealFile{"mosd_learn/learn0.pcd", 640, 480, 182'292, true, true},
                      RealFile{"tum/1341847980.723020.pcd", 640, 480, 248'250, true, false},
                      RealFile{"pcl/region_growing_rgb_tutorial.pcd", 640, 480, 259'847, true,
                               false},
                      RealFile{"pcl/room_scan1.pcd", 112'586, 1, 112'586, false, false},
                      RealFile{"livingroom1/fragment_002.ply", 112'698, 1, 112'698, true, false}));

}  // namespace
}  // namespace planescope
