// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
/// \file Segments a cloud and prints its planes and segments. Without an argument the cloud is a
/// room that the library makes up.
#include <cstdio>

#include "planescope/error.hpp"
#include "planescope/io.hpp"
#include "planescope/pipeline.hpp"
#include "planescope/synthesize.hpp"

int main(int argc, char** argv) try {
  const planescope::PointCloud cloud =
      argc > 1 ? planescope::read_cloud(argv[1]) : planescope::synthesize({.points = 60'000}).cloud;
  const auto options = planescope::Options::automatic(cloud);
  const planescope::Segmentation scene = planescope::segment(cloud, options);

  for (const planescope::SupportingPlane& plane : scene.planes) {
    const Eigen::Vector3f& n = plane.plane.normal;
    std::printf("plane %5.2f %5.2f %5.2f  %6.2f m  %6.2f m^2\n", n.x(), n.y(), n.z(),
                plane.plane.distance, plane.area);
  }
  for (const planescope::Segment& segment : scene.segments.segments) {
    std::printf("segment %3u  %7u points  %6.2f m^2  %s\n", segment.label, segment.point_count,
                segment.area, segment.plane == planescope::kNone ? "object" : "on a plane");
  }
  return 0;
} catch (const planescope::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return error.exit_code();
}
