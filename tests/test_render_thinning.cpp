// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "camera.hpp"
#include "fixtures.hpp"
#include "planescope/compare_pictures.hpp"
#include "planescope/render.hpp"
#include "test_render_scene.hpp"
#include "thinning.hpp"

/// \file Large clouds are thinned to what a picture can show, and it cannot be seen.
namespace planescope {
namespace {

using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

TEST(Thinning, KeepsTheNearestPointOfEachPixelByBruteForce) {
  std::mt19937_64 random(2);
  const auto uniform = [&] { return static_cast<float>(random() >> 40) / (1 << 24); };
  PointCloud cloud;
  for (int i = 0; i < 5000; ++i)
    cloud.positions.emplace_back(2 * uniform() - 1, 2 * uniform() - 1, 1 + 2 * uniform());
  std::vector<std::uint32_t> all(cloud.positions.size());
  std::iota(all.begin(), all.end(), 0U);
  Camera camera;  // at the origin, looking along +z
  camera.view_angle = 40;
  const int width = 40, height = 30;
  std::map<std::pair<int, int>, std::pair<double, std::uint32_t>> nearest;
  for (const std::uint32_t i : all) {
    const Eigen::Vector3d seen = draw::project(camera, 4.0 / 3, cloud.positions[i].cast<double>());
    if (!(seen.z() > 0) || std::abs(seen.x()) >= 1 || std::abs(seen.y()) >= 1) continue;
    const std::pair pixel(static_cast<int>(std::floor((seen.x() + 1) / 2 * width)),
                          static_cast<int>(std::floor((seen.y() + 1) / 2 * height)));
    const auto found = nearest.find(pixel);
    if (found == nearest.end() || seen.z() < found->second.first) nearest[pixel] = {seen.z(), i};
  }
  std::vector<std::uint32_t> expected;
  for (const auto& [pixel, best] : nearest) expected.push_back(best.second);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(draw::nearest_per_pixel(cloud, all, camera, width, height, 0), expected);
}

TEST(Thinning, CannotBeSeen) {
  const ToyScene toy = toy_room(0.006F);  // 1.6 million points: about 20 in a pixel
  const TemporaryFolder folder;
  RenderOptions options;
  options.size = {320, 240};
  for (const Layer layers : {Layer::Scene, Layer::Segments | Layer::Graph}) {
    options.layers = layers;
    options.thin_from = 0;
    render(toy.scene, toy.cloud, options, folder / "thinned.png");
    options.thin_from = toy.cloud.size() + 1;
    render(toy.scene, toy.cloud, options, folder / "whole.png");
    const auto found = compare_pictures(folder / "thinned.png", folder / "whole.png");
    EXPECT_LE(found.worst, kPictureTolerance);
  }
}

}  // namespace
}  // namespace planescope
