// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <locale>

#include "fixtures.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/result.hpp"
#include "toy_clouds.hpp"

/// \file A program that links the library may live in a country that writes 1.234,5.
namespace planescope {
namespace {

struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class WithCommas : public ::testing::Test {
 protected:
  WithCommas() : before_(std::locale::global(std::locale(std::locale(), new Commas))) {}
  ~WithCommas() override { std::locale::global(before_); }

 private:
  std::locale before_;
};

TEST_F(WithCommas, CloudsAreWrittenAndReadTheSame) {
  const testing::TemporaryFolder folder;
  const PointCloud cloud = testing::make_box_room(200);
  for (const char* name : {"a.pcd", "a.ply"}) {
    write_cloud(cloud, folder / name, CloudEncoding::Ascii);
    EXPECT_EQ(testing::read_bytes(folder / name).find(','), std::string::npos);
    EXPECT_EQ(read_cloud(folder / name).positions, cloud.positions);
  }
}

TEST_F(WithCommas, ResultsAreWrittenAndReadTheSame) {
  const testing::TemporaryFolder folder, classic;
  const PointCloud cloud = testing::make_box_room(2000);
  const Segmentation scene = segment(cloud, Options::room());
  save(scene, cloud, folder.path());
  const Result result = load_result(folder.path());
  EXPECT_EQ(result.voxel_size, 0.02);
  EXPECT_EQ(result.planes.size(), scene.planes.size());
  std::locale::global(std::locale::classic());
  save(scene, cloud, classic.path());
  EXPECT_EQ(testing::read_bytes(folder / "result.json"),
            testing::read_bytes(classic / "result.json"));
}

TEST_F(WithCommas, OptionsAreReadTheSame) {
  Options options;
  set_option(options, "planes.sigma", "0.03");
  EXPECT_EQ(options.planes.sigma, 0.03);
  EXPECT_EQ(get_option(options, "planes.sigma"), "0.03");
}

}  // namespace
}  // namespace planescope
