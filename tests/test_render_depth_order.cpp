// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "depth_order.hpp"

/// \file Painter's order, against rays that are shot through it.
namespace planescope::draw {
namespace {

FlatPolygon rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u,
                      const Eigen::Vector3d& v, std::size_t source) {
  FlatPolygon polygon;
  polygon.corners = {corner, corner + u, corner + u + v, corner + v};
  polygon.normal = u.cross(v).normalized();
  polygon.distance = polygon.normal.dot(corner);
  polygon.source = source;
  return polygon;
}

double polygon_area(const FlatPolygon& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.corners.size(); ++i)
    sum += (polygon.corners[i - 1] - polygon.corners[0])
               .cross(polygon.corners[i] - polygon.corners[0]);
  return sum.norm() / 2;
}

/// Distance along the ray where it meets the polygon.
std::optional<double> hit(const FlatPolygon& polygon, const Eigen::Vector3d& eye,
                          const Eigen::Vector3d& ray) {
  const double along = polygon.normal.dot(ray);
  if (std::abs(along) < 1e-9) return {};
  const double t = (polygon.distance - polygon.normal.dot(eye)) / along;
  if (t <= 0) return {};
  const Eigen::Vector3d p = eye + t * ray;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Eigen::Vector3d& a = polygon.corners[i];
    const Eigen::Vector3d& b = polygon.corners[(i + 1) % polygon.corners.size()];
    if ((b - a).cross(p - a).dot(polygon.normal) < 0) return {};
  }
  return t;
}

/// What a ray meets, in the polygons' order: (source, distance).
std::vector<std::pair<std::size_t, double>> hits(const std::vector<FlatPolygon>& polygons,
                                                 const Eigen::Vector3d& eye,
                                                 const Eigen::Vector3d& ray) {
  std::vector<std::pair<std::size_t, double>> found;
  for (const FlatPolygon& polygon : polygons)
    if (const auto t = hit(polygon, eye, ray)) found.emplace_back(polygon.source, *t);
  return found;
}

std::vector<FlatPolygon> random_rectangles(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  const auto vector = [&] {
    const auto one = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-52 - 1; };
    const double x = one(), y = one(), z = one();
    return Eigen::Vector3d(x, y, z);
  };
  std::vector<FlatPolygon> polygons;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d u = vector(), w = vector(), corner = vector();
    polygons.push_back(rectangle(corner, u, u.cross(w), i));
  }
  return polygons;
}

TEST(DepthOrder, every_ray_meets_the_same_polygons_farthest_first) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<FlatPolygon> polygons = random_rectangles(seed, 25);
    const Eigen::Vector3d eye(0.3, -4, 1);
    const std::vector<FlatPolygon> ordered = painters_order(polygons, eye);
    EXPECT_GT(ordered.size(), polygons.size());
    std::size_t met = 0;
    for (double x = -1; x <= 1; x += 0.083) {
      for (double z = -1.2; z <= 0.8; z += 0.083) {
        const Eigen::Vector3d ray(x - eye.x(), -eye.y(), z - eye.z());
        auto expected = hits(polygons, eye, ray);
        std::sort(expected.begin(), expected.end(),
                  [](const auto& a, const auto& b) { return a.second > b.second; });
        const auto found = hits(ordered, eye, ray);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].first, expected[i].first);
        met += found.size();
      }
    }
    EXPECT_GT(met, 500U);
  }
}

TEST(DepthOrder, keeps_area_and_cuts_only_what_crosses) {
  const std::vector<FlatPolygon> polygons = random_rectangles(4, 30);
  std::vector<double> areas(polygons.size(), 0);
  for (const FlatPolygon& piece : painters_order(polygons, {5, 5, 5}))
    areas[piece.source] += polygon_area(piece);
  for (std::size_t i = 0; i < polygons.size(); ++i)
    EXPECT_NEAR(areas[i], polygon_area(polygons[i]), 1e-5);
}

TEST(DepthOrder, three_that_hide_each_other_in_turn_are_cut) {
  // Three slats in a triangle, each above the next at one end and below it at the other.
  std::vector<FlatPolygon> slats;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = 2.0943951023931953 * static_cast<double>(i);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    slats.push_back(rectangle(turn * Eigen::Vector3d(-1, 0.3, -0.2),
                              turn * Eigen::Vector3d(2, 0, 0.4), turn * Eigen::Vector3d(0, 0.2, 0),
                              i));
  }
  EXPECT_GT(painters_order(slats, {0, 0, 5}).size(), 3U);
}

TEST(DepthOrder, of_a_box_from_outside_ends_with_what_faces_the_eye) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), o(0, 0, 0);
  const std::vector<FlatPolygon> box = {rectangle(x, y, z, 0), rectangle(o, y, z, 1),
                                        rectangle(y, x, z, 2), rectangle(o, x, z, 3),
                                        rectangle(z, x, y, 4), rectangle(o, x, y, 5)};
  const std::vector<FlatPolygon> ordered = painters_order(box, {5, 6, 7});
  ASSERT_EQ(ordered.size(), 6U) << "walls that touch are not cut";
  std::vector<std::size_t> last;
  for (std::size_t i = 3; i < 6; ++i) last.push_back(ordered[i].source);
  std::sort(last.begin(), last.end());
  EXPECT_EQ(last, (std::vector<std::size_t>{0, 2, 4}));
}

TEST(DepthOrder, keeps_the_order_of_one_plane_and_takes_nothing) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0);
  std::vector<FlatPolygon> tiles;
  for (std::size_t i = 0; i < 5; ++i)
    tiles.push_back(rectangle({0.3 * static_cast<double>(i), 0, 0}, x, y, i));
  const std::vector<FlatPolygon> ordered = painters_order(tiles, {0, 0, 3});
  ASSERT_EQ(ordered.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(ordered[i].source, i);
  EXPECT_TRUE(painters_order({}, {0, 0, 3}).empty());
}

}  // namespace
}  // namespace planescope::draw
