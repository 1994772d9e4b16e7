// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file Draws a scene without a display. Programs that draw call
/// planescope_enable_offscreen(<target>) in their CMakeLists.txt.
#include <cstdio>

#include "planescope/error.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/render.hpp"
#include "planescope/synthesize.hpp"

int main(int argc, char** argv) try {
  const char* png = argc > 1 ? argv[1] : "room.png";
  const planescope::PointCloud cloud = planescope::synthesize({.points = 60'000}).cloud;
  const auto scene = planescope::segment(cloud, planescope::Options::automatic(cloud));

  using planescope::Layer;
  planescope::RenderOptions options;
  options.layers = Layer::Segments | Layer::Graph;
  options.view = planescope::View::Iso;
  options.size = {800, 600};
  planescope::render(scene, cloud, options, png);
  std::printf("%s\n", png);
  return 0;
} catch (const planescope::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code();
}
