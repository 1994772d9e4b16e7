// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "fixtures.hpp"
#include "flip.hpp"
#include "image.hpp"
#include "planescope/compare_pictures.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"
#include "test_render_scene.hpp"

/// \file Pictures are compared as an eye would: what must pass and what must not.
namespace planescope {
namespace {

using draw::filled;
using draw::Image;
using draw::Pixel;
using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

float flat_error(const Pixel& a, const Pixel& b) {
  const auto errors = draw::flip_errors(filled(24, 20, a), filled(24, 20, b));
  const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
  EXPECT_NEAR(*least, *most, 1e-4F) << "flat pictures differ everywhere alike";
  return *most;
}

/// FLIP's colour error, worked by hand from CIELAB values of textbooks, L* a* b* (D65).
double by_hand(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const auto hunt = [](const Eigen::Vector3d& lab) {
    return Eigen::Vector3d(lab.x(), lab.x() / 100 * lab.y(), lab.x() / 100 * lab.z());
  };
  const auto hyab = [&](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
    const Eigen::Vector3d d = hunt(x) - hunt(y);
    return std::abs(d.x()) + std::hypot(d.y(), d.z());
  };
  const Eigen::Vector3d green(87.73, -86.18, 83.18), blue(32.30, 79.19, -107.86);
  const double most = std::pow(hyab(green, blue), 0.7), error = std::pow(hyab(a, b), 0.7);
  return error < 0.4 * most ? 0.95 / (0.4 * most) * error
                            : 0.95 + 0.05 * (error - 0.4 * most) / (0.6 * most);
}

TEST(Flip, OfFlatPicturesIsTheDistanceOfTheirColors) {
  EXPECT_EQ(flat_error({12, 34, 56}, {12, 34, 56}), 0);
  EXPECT_NEAR(flat_error({0, 255, 0}, {0, 0, 255}), 1, 1e-3);
  const Eigen::Vector3d white(100, 0, 0), black(0, 0, 0), red(53.24, 80.09, 67.20),
      middle(53.585, 0, 0), light(53.977, 0, 0);  // grey 128 and 129
  EXPECT_NEAR(flat_error({255, 255, 255}, {0, 0, 0}), by_hand(white, black), 2e-3);
  EXPECT_NEAR(flat_error({255, 0, 0}, {255, 255, 255}), by_hand(red, white), 2e-3);
  EXPECT_NEAR(flat_error({128, 128, 128}, {129, 129, 129}), by_hand(middle, light), 2e-3);
}

TEST(Flip, FineNoiseIsSeenLessThanTheSameDifferenceInOnePiece) {
  const Image grey = filled(64, 64, {128, 128, 128});
  Image checks = grey, half = grey;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t at = 3 * static_cast<std::size_t>(64 * y + x) + c;
        checks.rgb[at] = (x + y) % 2 == 0 ? 148 : 108;
        half.rgb[at] = x < 32 ? 148 : 108;
      }
    }
  }
  const auto mean = [&](const Image& image) {
    double sum = 0;
    for (const float error : draw::flip_errors(grey, image)) sum += static_cast<double>(error);
    return sum / (64 * 64);
  };
  EXPECT_LT(mean(checks), 0.3 * mean(half));
}

/// The filters as the paper prints them, in two dimensions at one pixel: an independent way.
TEST(Flip, AgreesWithThePapersFormulasAtAPoint) {
  // One white pixel on black: the error there is that of what the filters leave of it.
  Image dot = filled(41, 41, {0, 0, 0});
  const std::size_t middle = 20 * 41 + 20;
  for (std::size_t c = 0; c < 3; ++c) dot.rgb[3 * middle + c] = 255;
  const auto errors = draw::flip_errors(filled(41, 41, {0, 0, 0}), dot);
  // White has no chroma, so that Y alone is filtered: its kernel's value in the middle.
  const double ppd = draw::kPixelsPerDegree, pi = 3.14159265358979323846;
  double sum = 0, edge_sum = 0, point_positive = 0, point_negative = 0;
  const double sd = 0.5 * 0.082 * ppd;
  for (int y = -10; y <= 10; ++y) {
    for (int x = -10; x <= 10; ++x) {
      const double square = (x * x + y * y) / (ppd * ppd);
      sum += std::exp(-pi * pi * square / 0.0047);
      const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
      const double point = (x * x / (sd * sd) - 1) * g;
      if (std::abs(x) > 9 || std::abs(y) > 9) continue;
      edge_sum += x > 0 ? x * g : 0;
      (point > 0 ? point_positive : point_negative) += std::abs(point);
    }
  }
  const double luminance = 1 / sum;
  const double lightness =
      luminance > 0.008856 ? 116 * std::cbrt(luminance) - 16 : 903.3 * luminance;
  const double color = by_hand({lightness, 0, 0}, {0, 0, 0});
  // Edges cancel in the middle of a dot; of the point detector it is the middle weight, both ways.
  const double feature = std::sqrt(std::sqrt(2.0) / point_negative / std::sqrt(2.0));
  EXPECT_GT(edge_sum, 0);
  EXPECT_GT(point_positive, 0);
  EXPECT_NEAR(static_cast<double>(errors[middle]), std::pow(color, 1 - feature), 5e-3);
}

RenderOptions small(Layer layers) {
  RenderOptions options;
  options.layers = layers;
  options.size = {640, 480};
  return options;
}

/// Draws into the folder and compares with a.png there.
class Compared {
 public:
  explicit Compared(Layer layers) : layers_(layers), toy_(toy_room()) {
    draw(toy_, "a.png", [](RenderOptions&) {});
  }
  PictureComparison with(const std::function<void(ToyScene&)>& change) {
    ToyScene other = toy_;
    change(other);
    draw(other, "b.png", [](RenderOptions&) {});
    return compare_pictures(folder_ / "a.png", folder_ / "b.png");
  }
  PictureComparison drawn(const std::function<void(RenderOptions&)>& change) {
    draw(toy_, "b.png", change);
    return compare_pictures(folder_ / "a.png", folder_ / "b.png");
  }

 private:
  void draw(const ToyScene& toy, const char* name,
            const std::function<void(RenderOptions&)>& change) {
    RenderOptions options = small(layers_);
    change(options);
    render(toy.scene, toy.cloud, options, folder_ / name);
  }
  Layer layers_;
  ToyScene toy_;
  TemporaryFolder folder_;
};

TEST(ComparePictures, ARemadeOneIsTheSame) {
  const PictureComparison found = Compared(Layer::Graph).with([](ToyScene&) {});
  EXPECT_TRUE(found.identical());
  EXPECT_EQ(found.worst, 0);
  EXPECT_EQ(found.pixels, 640U * 480);
}

TEST(ComparePictures, AWrongOneIsBeyondTheTolerance) {
  Compared segments(Layer::Segments);
  EXPECT_GT(segments
                .with([](ToyScene& toy) {  // box 8 merged with the floor, as a wrong edge would
                  for (std::uint32_t& label : toy.scene.point_label) label = label == 8 ? 1 : label;
                })
                .worst,
            kPictureTolerance);
  EXPECT_GT(segments
                .with([](ToyScene& toy) {  // moved by 5 cm
                  for (std::size_t i = 0; i < toy.cloud.size(); ++i)
                    if (toy.scene.point_label[i] == 8) toy.cloud.positions[i].x() -= 0.05F;
                })
                .worst,
            kPictureTolerance);
  EXPECT_GT(segments.drawn([](RenderOptions& o) { o.layers = Layer::Planes; }).worst,
            kPictureTolerance);
  EXPECT_GT(segments.drawn([](RenderOptions& o) { o.annotation.axes = true; }).worst,
            kPictureTolerance);
  EXPECT_GT(segments.drawn([](RenderOptions& o) { o.camera.roll = 1; }).worst, kPictureTolerance);
  Compared titled(Layer::Segments);
  EXPECT_GT(titled.drawn([](RenderOptions& o) { o.annotation.title = "I"; }).worst,
            kPictureTolerance)
      << "one letter";
}

TEST(ComparePictures, OneFlippedEdgeIsBeyondTheTolerance) {
  Compared graph(Layer::Graph);
  // An edge of the floor, in the middle of the picture.
  const PictureComparison found = graph.with([](ToyScene& toy) {
    const auto& patches = toy.scene.graph.patches;
    const auto distance = [&](const Edge& edge) {
      return (0.5F * (patches[edge.first].centroid + patches[edge.second].centroid) -
              Eigen::Vector3f(3, 0.9F, 0))
          .norm();
    };
    Edge& edge =
        *std::min_element(toy.scene.edges.begin(), toy.scene.edges.end(),
                          [&](const Edge& p, const Edge& q) { return distance(p) < distance(q); });
    ASSERT_TRUE(edge.on);
    edge.on = false;
    edge.rule = EdgeRule::Concave;
  });
  EXPECT_GT(found.worst, kPictureTolerance);
  EXPECT_LT(found.mean, 0.01) << "which the mean of the picture would not have told";
}

TEST(ComparePictures, FindsWhereAndDrawsIt) {
  const TemporaryFolder folder;
  Image a = filled(200, 100, {255, 255, 255}), b = a;
  draw::paste(b, filled(20, 20, {200, 30, 30}), 150, 60);
  draw::write_png(a, folder / "a.png");
  draw::write_png(b, folder / "b.png");
  const PictureComparison found =
      compare_pictures(folder / "a.png", folder / "b.png", folder / "d.png");
  EXPECT_EQ(found.changed, 400U);
  EXPECT_NEAR(found.worst_at[0], 160, 8);
  EXPECT_NEAR(found.worst_at[1], 70, 8);
  EXPECT_GT(found.worst, 0.3);
  EXPECT_NEAR(found.mean * 200 * 100, found.worst * 24 * 24, 0.5 * found.worst * 24 * 24);
  const Image difference = draw::read_png(folder / "d.png");
  const auto at = [&](int x, int y) { return &difference.rgb[3 * (y * 200U + x)]; };
  EXPECT_EQ(at(20, 20)[0], at(20, 20)[2]) << "grey where nothing differs";
  EXPECT_GT(at(160, 70)[0], at(160, 70)[2] + 40) << "hot where it does";
}

TEST(ComparePictures, WhatIsTransparentIsComparedOnBothGrounds) {
  const TemporaryFolder folder;
  Image a = filled(64, 64, {255, 255, 255});
  Image b = a;
  b.alpha.assign(64 * 64, 255);
  draw::write_png(a, folder / "a.png");
  draw::write_png(b, folder / "b.png");
  EXPECT_TRUE(compare_pictures(folder / "a.png", folder / "b.png").identical());
  b.alpha.assign(64 * 64, 0);  // white on white: seen on black only
  draw::write_png(b, folder / "b.png");
  EXPECT_GT(compare_pictures(folder / "a.png", folder / "b.png").worst, 0.9);
}

TEST(ComparePictures, RefusesOtherSizesAndOtherFiles) {
  const TemporaryFolder folder;
  draw::write_png(filled(20, 20, {1, 2, 3}), folder / "a.png");
  draw::write_png(filled(20, 21, {1, 2, 3}), folder / "b.png");
  testing::write_bytes(folder / "c.png", "no picture");
  const auto kind = [&](const char* b) {
    try {
      compare_pictures(folder / "a.png", folder / b);
    } catch (const Error& error) {
      return error.kind();
    }
    return Error::Kind::Internal;
  };
  EXPECT_EQ(kind("b.png"), Error::Kind::Mismatch);
  EXPECT_EQ(kind("c.png"), Error::Kind::Input);
  EXPECT_EQ(kind("none.png"), Error::Kind::Input);
}

TEST(StoredEdges, AreThoseOfTheScene) {
  const ToyScene toy = toy_room();
  const TemporaryFolder folder;
  save(toy.scene, toy.cloud, folder.path());
  save_geometry(toy.scene, toy.cloud, folder.path());
  const auto edges = stored_edges(load_result(folder.path()), folder.path());
  ASSERT_EQ(edges.size(), toy.scene.edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& edge = toy.scene.edges[i];
    EXPECT_EQ(edges[i].first, edge.first);
    EXPECT_EQ(edges[i].second, edge.second);
    EXPECT_EQ(edges[i].on, edge.on);
    EXPECT_EQ(edges[i].rule, edge.rule);
  }
}

}  // namespace
}  // namespace planescope
