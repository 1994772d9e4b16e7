// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include <Eigen/Geometry>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include "fixtures.hpp"
#include "geometry.hpp"
#include "geometry_files.hpp"
#include "hull.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "scene_data.hpp"
#include "shape_layers.hpp"
#include "test_render_scene.hpp"
#include "vtk_arrays.hpp"

/// \file Hulls, the geometry that is drawn, and its files.
namespace planescope::draw {
namespace {

using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) / static_cast<double>(1ULL << 53);
}

/// The corners of a hull by definition: p is one if some line through it and another point has all
/// others on one side, strictly beyond it along the line.
std::set<std::pair<double, double>> brute_force_hull(const std::vector<Eigen::Vector2d>& points) {
  std::set<std::pair<double, double>> corners;
  for (const Eigen::Vector2d& a : points) {
    for (const Eigen::Vector2d& b : points) {
      const Eigen::Vector2d d = b - a;
      if (d.isZero(0)) continue;
      bool edge = true;
      for (const Eigen::Vector2d& p : points) {
        const double side = d.x() * (p - a).y() - d.y() * (p - a).x();
        const double along = d.dot(p - a) / d.squaredNorm();
        if (side < 0 || (side == 0 && (along < 0 || along > 1))) edge = false;
      }
      if (edge) corners.insert({{a.x(), a.y()}, {b.x(), b.y()}});
    }
  }
  return corners;
}

// VTK finds ranges with several threads: of 0 and -0 the file's RangeMin was now one, now the other.
TEST(Geometry, zeros_have_no_sign) {
  ToyScene toy = toy_room();
  for (std::size_t e = 0; e < toy.scene.edges.size(); ++e) {
    toy.scene.edges[e].margin = e % 2 == 0 ? -0.0F : 0.0F;
  }
  const auto graph = graph_geometry(toy.scene);
  vtkDataArray& margins = *graph->GetCellData()->GetArray("margin");
  ASSERT_GT(margins.GetNumberOfTuples(), 1);
  for (vtkIdType e = 0; e < margins.GetNumberOfTuples(); ++e) {
    EXPECT_FALSE(std::signbit(margins.GetTuple1(e))) << e;
  }
}

TEST(Hull, equals_the_definition_on_small_random_sets) {
  std::mt19937_64 random(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<Eigen::Vector2d> points;
    const int count = 3 + round % 20;
    const bool on_grid = round % 2 == 0;  // with repeated and collinear points
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d p(uniform(random), uniform(random));
      points.push_back(on_grid ? Eigen::Vector2d((p * 5).array().floor()) : p);
    }
    const std::vector<Eigen::Vector2d> hull = convex_hull(points);
    std::set<std::pair<double, double>> corners;
    for (const Eigen::Vector2d& p : hull) corners.insert({p.x(), p.y()});
    EXPECT_EQ(corners, brute_force_hull(points)) << "round " << round;
    EXPECT_EQ(corners.size(), hull.size());
    if (hull.size() > 2) {
      EXPECT_GT(polygon_area(hull), 0);
    }
  }
}

TEST(Hull, of_a_point_and_of_a_line) {
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}, {1, 2}}).size(), 1U);
  EXPECT_EQ(convex_hull({{0, 0}, {2, 2}, {1, 1}, {3, 3}}).size(), 2U);
  EXPECT_TRUE(convex_hull({}).empty());
}

TEST(Hull, area_of_a_square_and_axes_of_planes) {
  EXPECT_DOUBLE_EQ(polygon_area({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 4);
  EXPECT_DOUBLE_EQ(polygon_area({{0, 2}, {2, 2}, {2, 0}, {0, 0}}), -4);
  for (const Eigen::Vector3d& n : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, -1, 0),
                                   Eigen::Vector3d(1, 2, 3).normalized()}) {
    const auto [u, v] = plane_axes(n);
    EXPECT_NEAR((u.cross(v) - n).norm(), 0, 1e-12);
    EXPECT_NEAR(u.norm(), 1, 1e-12);
  }
}

TEST(Geometry, hulls_of_the_room_are_its_faces) {
  const ToyScene toy = toy_room();
  const auto planes = plane_geometry(toy.scene, toy.cloud);
  ASSERT_EQ(planes->GetNumberOfPolys(), 6);  // floor, four walls, table
  const double expected[] = {12, 7.2, 7.2, 9.6, 9.6, 1.4 * 0.8};
  vtkCellData& data = *planes->GetCellData();
  for (vtkIdType i = 0; i < 6; ++i) {
    EXPECT_EQ(data.GetArray("plane")->GetTuple1(i), static_cast<double>(i));
    EXPECT_EQ(data.GetArray("label")->GetTuple1(i), static_cast<double>(i) + 1);
    EXPECT_NEAR(data.GetArray("area")->GetTuple1(i), expected[i], 0.03 * expected[i]);
    for (const vtkIdType corner : corners(*planes->GetPolys(), i)) {
      const Plane& plane = toy.scene.planes[static_cast<std::size_t>(i)].plane;
      EXPECT_NEAR(plane.signed_distance(point(*planes, corner)), 0, 1e-5);
    }
  }
}

TEST(Geometry, graph_says_every_edge) {
  const ToyScene toy = toy_room();
  const auto graph = graph_geometry(toy.scene);
  ASSERT_EQ(graph->GetNumberOfLines(), static_cast<vtkIdType>(toy.scene.edges.size()));
  for (std::size_t i = 0; i < toy.scene.edges.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    const auto ends = corners(*graph->GetLines(), id);
    EXPECT_EQ(ends[0], toy.scene.edges[i].first);
    EXPECT_EQ(ends[1], toy.scene.edges[i].second);
    EXPECT_EQ(graph->GetCellData()->GetArray("on")->GetTuple1(id) != 0, toy.scene.edges[i].on);
    EXPECT_EQ(graph->GetCellData()->GetArray("rule")->GetTuple1(id),
              static_cast<double>(toy.scene.edges[i].rule));
  }
  const EdgeCounts counts = count_edges(scene_data(toy.scene, toy.cloud));
  const auto rules = count_rules(toy.scene.edges);
  EXPECT_EQ(counts.on, rules[0] + rules[3] + rules[4]);  // SamePlane, Convex, NearlyFlat
  EXPECT_EQ(counts.on + counts.off, toy.scene.edges.size());
}

/// All that is in two data sets, compared value by value; points up to `slack` [m].
void expect_equal(vtkPolyData& a, vtkPolyData& b, float slack) {
  ASSERT_EQ(a.GetNumberOfPoints(), b.GetNumberOfPoints());
  ASSERT_EQ(a.GetNumberOfCells(), b.GetNumberOfCells());
  for (vtkIdType i = 0; i < a.GetNumberOfPoints(); ++i)
    ASSERT_LE((point(a, i) - point(b, i)).cwiseAbs().maxCoeff(), slack) << i;
  const auto compare = [](vtkDataSetAttributes& x, vtkDataSetAttributes& y) {
    ASSERT_EQ(x.GetNumberOfArrays(), y.GetNumberOfArrays());
    for (int k = 0; k < x.GetNumberOfArrays(); ++k) {
      vtkDataArray& column = *x.GetArray(k);
      vtkDataArray* other = y.GetArray(column.GetName());
      ASSERT_NE(other, nullptr) << column.GetName();
      ASSERT_EQ(column.GetNumberOfValues(), other->GetNumberOfValues()) << column.GetName();
      for (vtkIdType i = 0; i < column.GetNumberOfTuples(); ++i)
        for (int c = 0; c < column.GetNumberOfComponents(); ++c)
          ASSERT_EQ(column.GetComponent(i, c), other->GetComponent(i, c)) << column.GetName();
    }
  };
  compare(*a.GetPointData(), *b.GetPointData());
  compare(*a.GetCellData(), *b.GetCellData());
}

TEST(GeometryFiles, come_back_as_they_were_and_are_the_same_bytes_twice) {
  ToyScene toy = toy_room();
  for (const Eigen::Vector3d& origin :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(500000, -3000000, 12)}) {
    toy.cloud.origin = origin;
    const TemporaryFolder folder, again;
    save_geometry(toy.scene, toy.cloud, folder.path());
    save_geometry(toy.scene, toy.cloud, again.path());
    for (const char* name : {"patches.vtp", "graph.vtp", "planes.vtp"})
      EXPECT_EQ(testing::read_bytes(folder / name), testing::read_bytes(again / name)) << name;
    const SceneData memory = scene_data(toy.scene, toy.cloud);
    const SceneData stored = add_geometry(memory.result, folder.path());
    // Map coordinates round positions by a nanometre.
    const float slack = origin.isZero() ? 0.0F : 1e-8F;
    expect_equal(*memory.planes, *stored.planes, slack);
    expect_equal(*memory.patches, *stored.patches, slack);
    expect_equal(*memory.graph, *stored.graph, slack);
  }
}

TEST(GeometryFiles, that_are_damaged_or_belong_elsewhere_are_refused) {
  const ToyScene toy = toy_room(0.05F, 0.3F);
  const SceneData memory = scene_data(toy.scene, toy.cloud);
  const TemporaryFolder folder;
  const auto refused = [&](const char* name, const std::string& bytes) {
    save_geometry(toy.scene, toy.cloud, folder.path());
    testing::write_bytes(folder / name, bytes);
    try {
      add_geometry(memory.result, folder.path());
    } catch (const Error& error) {
      return error.kind() == Error::Kind::Input &&
             std::string(error.what()).find(name) != std::string::npos;
    }
    return false;
  };
  save_geometry(toy.scene, toy.cloud, folder.path());
  const std::string patches = testing::read_bytes(folder / "patches.vtp");
  const std::string graph = testing::read_bytes(folder / "graph.vtp");
  EXPECT_TRUE(refused("patches.vtp", ""));
  EXPECT_TRUE(refused("patches.vtp", "not XML at all"));
  EXPECT_TRUE(refused("patches.vtp", patches.substr(0, patches.size() / 2)));
  EXPECT_TRUE(refused("patches.vtp", graph)) << "another file's arrays";
  std::string many = patches;
  const std::string count = "NumberOfPoints=\"";
  many.insert(many.find(count) + count.size(), "99999999");
  EXPECT_TRUE(refused("patches.vtp", many)) << "more points than bytes could hold";
  const ToyScene other = toy_room(0.05F, 0.4F);
  const TemporaryFolder elsewhere;
  save_geometry(other.scene, other.cloud, elsewhere.path());
  EXPECT_TRUE(refused("graph.vtp", testing::read_bytes(elsewhere / "graph.vtp")));
  ToyScene wrong = toy_room(0.05F, 0.3F);
  wrong.scene.patch_plane[5].plane = 77;
  save_geometry(wrong.scene, wrong.cloud, elsewhere.path());
  EXPECT_TRUE(refused("patches.vtp", testing::read_bytes(elsewhere / "patches.vtp")));
}

TEST(GeometryFiles, spoilt_anywhere_are_taken_or_refused_in_words) {
  const ToyScene toy = toy_room(0.05F, 0.3F);
  const SceneData memory = scene_data(toy.scene, toy.cloud);
  const TemporaryFolder folder;
  save_geometry(toy.scene, toy.cloud, folder.path());
  const std::string whole = testing::read_bytes(folder / "graph.vtp");
  std::mt19937_64 random(5);
  int refused = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::string spoilt = whole;
    // Half of them in the XML, the rest anywhere.
    const std::size_t range = trial % 2 == 0 ? whole.find('_') : whole.size();
    for (std::uint64_t k = random() % 3 + 1; k > 0; --k)
      spoilt[random() % range] =
          trial % 4 < 2 ? static_cast<char>('0' + random() % 10) : static_cast<char>(random());
    if (trial % 10 == 9) spoilt.resize(random() % whole.size());
    testing::write_bytes(folder / "graph.vtp", spoilt);
    try {
      add_geometry(memory.result, folder.path());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Input) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace planescope::draw
