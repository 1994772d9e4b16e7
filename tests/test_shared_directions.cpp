// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "planes/shared_directions.hpp"
#include "planes/support.hpp"
#include "planes_fixtures.hpp"

namespace planescope {
namespace {

using testing::PatchGraphBuilder;
using V = Eigen::Vector3f;

double degrees_between(const V& a, const V& b) {
  const Eigen::Vector3d u = a.cast<double>(), v = b.cast<double>();
  return std::atan2(u.cross(v).norm(), std::abs(u.dot(v))) * 180 / std::numbers::pi;
}

V turned(const V& v, const V& axis, double degrees) {
  return Eigen::AngleAxisf(static_cast<float>(degrees * std::numbers::pi / 180), axis) * v;
}

// Rectangles with noise, each a plane of its own that was fitted to its patches alone.
class Rectangles {
 public:
  Rectangles(float noise, std::uint64_t seed) : builder_(0.1f, noise, 0.03f, seed) {}

  void add(const V& corner, const V& u, const V& v, PlaneRole role = PlaneRole::Support) {
    builder_.rectangle(corner, u, v);
    assignment_.resize(builder_.patches().size(), static_cast<std::int32_t>(truth.size()));
    truth.push_back(u.cross(v).normalized());
    roles_.push_back(role);
  }

  void fit() {
    graph_.patches = builder_.patches();
    PlaneSelection selection;
    for (std::size_t p = 0; p < truth.size(); ++p) {
      selection.selected.push_back(static_cast<std::uint32_t>(p));
      selection.hypotheses.push_back({.plane = {truth[p], 0}});
    }
    Support support = refit_planes(graph_, selection, assignment_);
    planes.resize(truth.size());
    for (const SupportingPlane& plane : support.planes) {
      planes[plane.hypothesis] = plane;
      planes[plane.hypothesis].role = roles_[plane.hypothesis];
    }
  }

  void share(const DirectionTolerance& tolerance) {
    share_directions(planes, graph_.patches, assignment_, tolerance);
  }

  // Weighted sum of squared distances, were the planes' normals turned all together: the offsets
  // are free. Each plane's variance before the fit is its weight.
  double cost(const V& axis, double degrees, const std::vector<double>& variances) const {
    double sum = 0;
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const Eigen::Vector3d n = turned(planes[p].plane.normal, axis, degrees).cast<double>();
      double first = 0, second = 0, area = 0;
      for (std::size_t i = 0; i < assignment_.size(); ++i) {
        if (assignment_[i] != static_cast<std::int32_t>(p)) continue;
        const double r = n.dot(graph_.patches[i].centroid.cast<double>()),
                     a = double(graph_.patches[i].area);
        area += a, first += a * r, second += a * r * r;
      }
      sum += (second - first * first / area) / variances[p];
    }
    return sum;
  }

  std::vector<SupportingPlane> planes;
  std::vector<V> truth;

 private:
  PatchGraphBuilder builder_;
  PatchGraph graph_;
  std::vector<std::int32_t> assignment_;
  std::vector<PlaneRole> roles_;
};

constexpr DirectionTolerance kTolerance{
    .angle = 10, .face_sigma = 0.02, .support_sigma = 0.05, .surface_error = 0};

// A floor, two walls, a table top and the side of a box, turned about z so that no axis is special.
Rectangles furnished(std::uint64_t seed) {
  Rectangles room(0.01f, seed);
  const auto at = [](const V& v) { return turned(v, V::UnitZ(), 25); };
  room.add(V(0, 0, 0), at(V(4, 0, 0)), at(V(0, 4, 0)));
  room.add(V(0, 0, 0), at(V(0, 4, 0)), V(0, 0, 2.4f));
  room.add(V(0, 0, 0), V(0, 0, 2.4f), at(V(4, 0, 0)));
  room.add(at(V(1, 1, 0.7f)), at(V(1, 0, 0)), at(V(0, 0.6f, 0)), PlaneRole::Face);
  room.add(at(V(2, 2, 0)), at(V(0.4f, 0, 0)), V(0, 0, 0.3f), PlaneRole::Face);
  room.fit();
  return room;
}

TEST(SharedDirections, MakeNoisyPlanesExactlyParallelOrOrthogonal) {
  double error_before = 0, error_after = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rectangles room = furnished(seed);
    for (std::size_t p = 0; p < room.planes.size(); ++p)
      error_before += degrees_between(room.planes[p].plane.normal, room.truth[p]);
    room.share(kTolerance);
    for (std::size_t p = 0; p < room.planes.size(); ++p) {
      error_after += degrees_between(room.planes[p].plane.normal, room.truth[p]);
      EXPECT_LT(degrees_between(room.planes[p].plane.normal, room.truth[p]), 0.2);
      for (std::size_t q = 0; q < p; ++q) {
        EXPECT_LT(manhattan_deviation(room.planes[p].plane.normal, room.planes[q].plane.normal),
                  1e-4);
      }
    }
  }
  EXPECT_LT(error_after, 0.4 * error_before);  // the walls teach the box its direction
}

TEST(SharedDirections, AreTheWeightedLeastSquaresOverRotations) {
  Rectangles room = furnished(3);
  std::vector<double> variances;  // that each may have
  for (const SupportingPlane& plane : room.planes) {
    const double sigma = plane.role == PlaneRole::Face ? 0.02 : 0.05;
    variances.push_back(std::max(2.25 * std::pow(double(plane.rms), 2), 0.0625 * sigma * sigma));
  }
  room.share(kTolerance);
  const double least = room.cost(V::UnitZ(), 0, variances);
  for (const V& axis : {V(1, 0, 0), V(0, 1, 0), V(0, 0, 1), V(0.6f, 0, 0.8f)}) {
    EXPECT_GT(room.cost(axis, 0.1, variances), least);
    EXPECT_GT(room.cost(axis, -0.1, variances), least);
  }
}

TEST(SharedDirections, LeaveASlantedPlaneAsItWasFitted) {
  for (const double slant : {2.0, 5.0, 9.0, 30.0, 45.0}) {
    Rectangles room(0.003f, 5);
    room.add(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
    room.add(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2.4f));
    room.add(V(0, 0, 0), V(0, 0, 2.4f), V(4, 0, 0));
    const V up = turned(V(0, 0, 1), V(1, 0, 0), slant);  // a wall that leans, and turns aside
    room.add(V(0, 4, 0), turned(V(4, 0, 0), up, slant), 2.4f * up);
    room.fit();
    const V before = room.planes[3].plane.normal;
    room.share(kTolerance);
    EXPECT_EQ(room.planes[3].plane.normal, before) << slant;
    EXPECT_LT(degrees_between(before, room.truth[3]), 0.2) << slant;
  }
}

// 3 degrees across 0.2 m lift the rms by 3 mm, less than the noise of 5 mm allows; across 1 m, by
// 15 mm.
TEST(SharedDirections, GoByTheWidthOfAPlane) {
  for (const bool wide : {false, true}) {
    Rectangles room(0.005f, 6);
    room.add(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
    room.add(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2.4f));
    const V along = turned(V(1, 0, 0), V(0, 1, 0), 3);
    room.add(V(1, 1, 0.5f), (wide ? 1.0f : 0.2f) * along, V(0, 1, 0), PlaneRole::Face);
    room.fit();
    room.share(kTolerance);
    const double slant = degrees_between(room.planes[2].plane.normal, room.planes[0].plane.normal);
    EXPECT_NEAR(slant, wide ? 3 : 0, wide ? 0.3 : 1e-4);
  }
}

TEST(SharedDirections, ForgiveWhatSmoothingDoes) {
  Rectangles room(0.002f, 7);
  room.add(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
  const V along = turned(V(1, 0, 0), V(0, 1, 0), 4);
  room.add(V(1, 1, 0.5f), 0.4f * along, V(0, 1, 0), PlaneRole::Face);  // rms of the turn: 8 mm
  room.fit();
  Rectangles strict = room;
  strict.share(kTolerance);
  EXPECT_NEAR(degrees_between(strict.planes[1].plane.normal, V::UnitZ()), 4, 0.5);
  DirectionTolerance smoothed = kTolerance;
  smoothed.surface_error = surface_error(0.025);  // 11 mm
  room.share(smoothed);
  EXPECT_LT(manhattan_deviation(room.planes[1].plane.normal, room.planes[0].plane.normal), 1e-4);
}

TEST(SharedDirections, LetATurnedBoxShareTheVertical) {
  Rectangles room(0.004f, 8);
  room.add(V(0, 0, 0), V(4, 0, 0), V(0, 4, 0));
  room.add(V(0, 0, 0), V(0, 4, 0), V(0, 0, 2.4f));
  room.add(V(0, 0, 0), V(0, 0, 2.4f), V(4, 0, 0));
  const V a = turned(V(1, 0, 0), V::UnitZ(), 35), b = turned(V(0, 1, 0), V::UnitZ(), 35);
  room.add(V(2, 2, 0), 0.6f * a, V(0, 0, 0.5f), PlaneRole::Face);
  room.add(V(2, 2, 0), 0.5f * b, V(0, 0, 0.5f), PlaneRole::Face);
  room.fit();
  room.share(kTolerance);
  const auto normal = [&](std::size_t p) { return room.planes[p].plane.normal; };
  EXPECT_LT(std::abs(double(normal(3).dot(normal(4)))), 1e-6);
  for (const std::size_t side : {3u, 4u}) {
    EXPECT_LT(std::abs(double(normal(side).dot(normal(0)))), 1e-6);
    EXPECT_LT(degrees_between(normal(side), room.truth[side]), 1);
    EXPECT_GT(manhattan_deviation(normal(side), normal(1)), 30);
  }
}

TEST(SharedDirections, KeepPlanesThroughTheirPatches) {
  Rectangles room = furnished(4);
  room.share(kTolerance);
  EXPECT_NEAR(room.planes[3].plane.signed_distance(turned(V(1.5f, 1.3f, 0.7f), V::UnitZ(), 25)), 0,
              0.005);
  for (const SupportingPlane& plane : room.planes) EXPECT_NEAR(plane.rms, 0.01, 0.004);
}

TEST(SharedDirections, OfNoPlanesOrWithoutTolerance) {
  std::vector<SupportingPlane> none;
  share_directions(none, {}, {}, kTolerance);
  EXPECT_TRUE(none.empty());
  Rectangles room = furnished(1);
  const std::vector<SupportingPlane> before = room.planes;
  DirectionTolerance off = kTolerance;
  off.angle = 0;
  room.share(off);
  for (std::size_t p = 0; p < before.size(); ++p)
    EXPECT_EQ(room.planes[p].plane.normal, before[p].plane.normal);
}

}  // namespace
}  // namespace planescope
