// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>

#include "fixtures.hpp"
#include "gl/context.hpp"
#include "image.hpp"
#include "planescope/compare_pictures.hpp"
#include "planescope/error.hpp"
#include "planescope/render.hpp"
#include "planescope/result.hpp"
#include "test_render_scene.hpp"

/// \file Whole pictures: the bridge, what is in them, and that they do not change by themselves.
namespace planescope {
namespace {

using draw::Image;
using testing::TemporaryFolder;
using testing::toy_room;
using testing::ToyScene;

Error::Kind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "no error was thrown";
  return Error::Kind::Internal;
}

RenderOptions small(Layer layers) {
  RenderOptions options;
  options.layers = layers;
  options.size = {320, 240};
  return options;
}

Image picture(const ToyScene& toy, const RenderOptions& options) {
  const TemporaryFolder folder;
  render(toy.scene, toy.cloud, options, folder / "a.png");
  return draw::read_png(folder / "a.png");
}

std::size_t count(const Image& image, const std::function<bool(int r, int g, int b)>& is) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    if (is(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2])) ++n;
  return n;
}

/// Compares with tests/baselines/<name>.png; PLANESCOPE_WRITE_BASELINES=1 writes it instead.
void expect_baseline(const Image& image, const std::string& name) {
  const std::filesystem::path file =
      std::filesystem::path(PLANESCOPE_SOURCE_DIR) / "tests/baselines" / (name + ".png");
  if (std::getenv("PLANESCOPE_WRITE_BASELINES") != nullptr) draw::write_png(image, file);
  const TemporaryFolder folder;
  draw::write_png(image, folder / "now.png");
  EXPECT_LE(compare_pictures(file, folder / "now.png").worst, kPictureTolerance) << name;
}

TEST(Bridge, gives_a_context_and_names_its_renderer) {
  const auto context = draw::make_gl_context();
  EXPECT_TRUE(context->is_current());
  EXPECT_TRUE(draw::bridge_is_visible());
  EXPECT_GE(context->max_size(), 4096);
  EXPECT_NE(gl_renderer().find("LLVM"), std::string::npos) << gl_renderer();
  EXPECT_EQ(vtk_version().substr(0, 2), "9.");
}

TEST(Bridge, refuses_in_our_words_before_vtk_could_crash) {
  EXPECT_EQ(kind_of([] { draw::make_gl_context({9, 9}); }), Error::Kind::Rendering);
}

TEST(Pictures, equal_their_baselines) {
  const ToyScene toy = toy_room();
  expect_baseline(picture(toy, small(Layer::Scene)), "scene");
  expect_baseline(picture(toy, small(Layer::Segments)), "segments");
  expect_baseline(picture(toy, small(Layer::Planes)), "planes");
  expect_baseline(picture(toy, small(Layer::Graph)), "graph");
}

TEST(Pictures, are_the_same_bytes_twice) {
  const ToyScene toy = toy_room();
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "b.png"}) {
    RenderOptions options = small(Layer::Segments | Layer::Planes | Layer::Graph);
    options.annotation.title = "Twice";
    render(toy.scene, toy.cloud, options, folder / name);
  }
  EXPECT_EQ(testing::read_bytes(folder / "a.png"), testing::read_bytes(folder / "b.png"));
}

TEST(Pictures, of_a_stored_result_equal_those_from_memory) {
  const ToyScene toy = toy_room();
  const TemporaryFolder folder;
  save(toy.scene, toy.cloud, folder.path());
  save_geometry(toy.scene, toy.cloud, folder.path());
  for (const Layer layers : {Layer::Segments, Layer::Scene | Layer::Planes, Layer::Graph}) {
    render(folder.path(), small(layers), folder / "stored.png");
    EXPECT_EQ(draw::read_png(folder / "stored.png"), picture(toy, small(layers)));
  }
}

TEST(Pictures, on_and_off_edges_differ_in_width_and_in_grey) {
  const ToyScene toy = toy_room();
  RenderOptions options = small(Layer::Graph);
  options.size = {960, 720};
  const Image image = picture(toy, options);
  const auto is_on = [](int r, int g, int b) { return b > r + 60 && b > g + 40; };
  const auto is_off = [](int r, int g, int b) { return r > b + 90 && r > g + 60; };
  // Length of a run of such pixels along rows: a measure of a line's width.
  const auto mean_run = [&](const auto& is) {
    double pixels = 0, runs = 0;
    bool inside = false;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      const bool now = is(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
      pixels += now ? 1 : 0;
      runs += now && !inside ? 1 : 0;
      inside = now;
    }
    return pixels / std::max(runs, 1.0);
  };
  EXPECT_GT(count(image, is_on), 2000U);
  EXPECT_GT(count(image, is_off), 1000U);
  EXPECT_GT(mean_run(is_off), 1.5 * mean_run(is_on));
  const auto mean_luma = [&](const auto& is) {
    double sum = 0;
    count(image, [&](int r, int g, int b) {
      if (is(r, g, b)) sum += 0.2126 * r + 0.7152 * g + 0.0722 * b;
      return false;
    });
    return sum / static_cast<double>(count(image, is));
  };
  EXPECT_GT(std::abs(mean_luma(is_off) - mean_luma(is_on)), 15);
}

TEST(Pictures, show_the_inside_of_the_room) {
  ToyScene toy = toy_room();
  for (std::size_t i = 0; i < toy.cloud.size(); ++i) {  // the box on the table in a loud green
    const bool box = toy.scene.point_label[i] == 10;
    toy.cloud.colors[i] = box ? Rgb{0, 255, 0} : Rgb{120, 120, 120};
  }
  const auto is_green = [](int r, int g, int b) { return g > r + 80 && g > b + 80; };
  RenderOptions options = small(Layer::Scene);
  const std::size_t seen = count(picture(toy, options), is_green);
  EXPECT_GT(seen, 150U);
  options.cull_front = false;
  options.view = View::Front;  // through a wall, from outside
  EXPECT_EQ(count(picture(toy, options), is_green), 0U);
  options.cull_front = true;
  EXPECT_GT(count(picture(toy, options), is_green), 100U);
}

TEST(Pictures, refuse_to_be_uniform) {
  ToyScene toy = toy_room();
  toy.cloud.colors.assign(toy.cloud.size(), {255, 255, 255});
  const TemporaryFolder folder;
  RenderOptions options = small(Layer::Scene);
  options.eye_dome_lighting = false;
  options.annotation.title = "Words do not count";
  EXPECT_EQ(kind_of([&] { render(toy.scene, toy.cloud, options, folder / "a.png"); }),
            Error::Kind::Rendering);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Pictures, take_all_sizes_and_refuse_what_is_none) {
  const ToyScene toy = toy_room(0.05F, 0.3F);
  for (const std::array<int, 2> size : {std::array{16, 16}, {16384, 16}, {640, 17}, {33, 700}}) {
    RenderOptions options = small(Layer::Segments);
    options.size = size;
    options.supersample = 4;  // too much for the widest: then it is less
    options.annotation.title = "A title that is longer than the smallest pictures are wide";
    const Image image = picture(toy, options);
    EXPECT_EQ(image.width, size[0]);
    EXPECT_EQ(image.height, size[1]);
  }
  for (const std::array<int, 2> size :
       {std::array{15, 100}, {100, 16385}, {-1, 100}, {16384, 16384}}) {
    RenderOptions options = small(Layer::Segments);
    options.size = size;
    EXPECT_EQ(kind_of([&] { picture(toy, options); }), Error::Kind::Usage);
  }
}

TEST(Pictures, refuse_options_out_of_range) {
  const ToyScene toy = toy_room(0.05F, 0.3F);
  const auto with = [&](const std::function<void(RenderOptions&)>& change) {
    RenderOptions options = small(Layer::Segments);
    change(options);
    return kind_of([&] { picture(toy, options); });
  };
  EXPECT_EQ(with([](RenderOptions& o) { o.supersample = 0; }), Error::Kind::Usage);
  EXPECT_EQ(with([](RenderOptions& o) { o.background = {0, 2, 0}; }), Error::Kind::Usage);
  EXPECT_EQ(with([](RenderOptions& o) { o.point_size = NAN; }), Error::Kind::Usage);
  EXPECT_EQ(with([](RenderOptions& o) { o.up = Eigen::Vector3f::Zero(); }), Error::Kind::Usage);
  EXPECT_EQ(with([](RenderOptions& o) { o.view = View::Sensor; }), Error::Kind::Usage);
}

TEST(Pictures, are_not_written_into_a_folder_that_is_not_there) {
  const ToyScene toy = toy_room(0.05F, 0.3F);
  const TemporaryFolder folder;
  EXPECT_EQ(
      kind_of([&] { render(toy.scene, toy.cloud, small(Layer::Scene), folder / "none/a.png"); }),
      Error::Kind::Input);
}

TEST(Overview, has_four_panels_and_three_pictures_beside_it) {
  const ToyScene toy = toy_room();
  const TemporaryFolder folder;
  RenderOptions options;
  options.size = {640, 480};
  render_pictures(toy.scene, toy.cloud, options, folder.path());
  for (const char* name : {"segments.png", "planes.png", "graph.png"})
    EXPECT_EQ(draw::read_png(folder / name).width, 640) << name;
  const Image overview = draw::read_png(folder / "overview.png");
  ASSERT_EQ(overview.width, 640);
  ASSERT_EQ(overview.height, 480);
  for (int panel = 0; panel < 4; ++panel) {  // something in each, and no two alike
    std::size_t drawn = 0, same = 0;
    for (int y = 0; y < 239; ++y) {
      for (int x = 0; x < 319; ++x) {
        const auto at = [&](int p) {
          return overview.rgb.data() + 3 * ((y + 241 * (p / 2)) * 640 + x + 321 * (p % 2));
        };
        drawn += at(panel)[1] < 250 ? 1 : 0;
        same += std::equal(at(panel), at(panel) + 3, at((panel + 1) % 4)) ? 1 : 0;
      }
    }
    EXPECT_GT(drawn, 239U * 319 / 5) << panel;
    EXPECT_LT(same, 239U * 319 * 9 / 10) << panel;
  }
}

}  // namespace
}  // namespace planescope
