// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "automatic.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "patches/smoothing.hpp"
#include "planescope/error.hpp"
#include "planescope/options.hpp"
#include "single_scan.hpp"

namespace planescope {
namespace {

// Two digits are all that a derived value deserves, and they read well in reports.
double two_digits(double value) {
  const double scale = std::pow(10.0, 1 - std::floor(std::log10(value)));
  return scale >= 1 ? std::round(value * scale) / scale : std::round(value);  // shortest decimals
}

// A camera's steps of depth grow with z^2, twice the noise each (Khoshelham and Elberink): the
// smallest exponent at which voxels that are good at the median range still hold two steps far
// away.
double view_exponent(const CloudScale& scale, double voxel) {
  constexpr double kLargest = 0.7, kStep = 0.1;
  const double steps = 2.5 * 0.0014 * scale.far_range * scale.far_range;
  const double growth = scale.far_range / scale.median_range;
  double exponent = 0;
  while (exponent < kLargest && voxel * std::pow(growth, exponent) / (1 - exponent) < steps) {
    exponent += kStep;
  }
  return std::round(exponent * 10) / 10;
}

// Depth images that were put together without fusion: a map whose points scatter across the surface
// more widely than fine voxels are, and more than the distance between them explains.
bool scatters(const PointCloud& cloud, const CloudScale& scale) {
  const bool map = !cloud.organised() && scale.median_range == 0;
  return map && scale.noise > std::max(0.25 * scale.spacing, 0.004);
}

[[noreturn]] void refuse_units(const CloudScale& scale) {
  std::ostringstream message;
  message << "the cloud spans " << scale.extent.norm() << " m and its points lie " << scale.spacing
          << " m apart, too far for surfaces: is it in millimetres? Scale it to metres, or give "
             "the options yourself "
             "(--preset room)";
  throw Error(Error::Kind::Computation, message.str());
}

}  // namespace

Options Options::automatic(const PointCloud& cloud) {
  return automatic_options(cloud, measure_scale(cloud));
}

Options automatic_options(const PointCloud& cloud, CloudScale scale) {
  Options options;
  constexpr double kLargestVoxel = 2;  // [m] indoors, a voxel this large is a mistake of units
  if (!(scale.connected_voxel <= kLargestVoxel)) refuse_units(scale);
  if (scatters(cloud, scale)) {
    options.patches.smoothing = two_digits(std::max(1.2 * scale.noise, scale.connected_voxel));
    scale = measure_scale(smooth_points(cloud, options.patches.smoothing));
  }
  // Patches need voxels, and normals a base well above the noise; voxels must meet their
  // neighbours, so they are above the spacing, and finer than the smoothing they have nothing to
  // say.
  const double base = std::max({0.03, 10 * scale.noise, 3 * options.patches.smoothing});
  const double voxel = std::max({base / 4, scale.connected_voxel, options.patches.smoothing});
  options.patches.voxel_size = two_digits(voxel);
  options.patches.patch_size = two_digits(std::max(base, 2.5 * voxel));
  if (scale.median_range > 0) {
    options.patches.range_exponent =
        cloud.organised() ? view_exponent(scale, voxel) : kScanRangeExponent;
  }
  // Patches of one surface lie within a few deviations of its plane; what lies further off is
  // another thing.
  options.planes.sigma = two_digits(std::clamp(std::max(5 * scale.noise, voxel / 4), 0.01, 0.2));
  // Supporting planes carry the scene: a table top among cups, the walls among furniture. A tenth
  // of what a table-top view shows; the more a scene shows, the smaller the share of one plane.
  const double surface = double(scale.finite_points) * scale.spacing * scale.spacing;  // [m^2]
  const double area = std::clamp(0.1 * std::pow(surface, 0.75), 1e-4, 1e3);
  options.planes.min_area = two_digits(area);
  options.planes.face_area = two_digits(area / 50);
  return options;
}

}  // namespace planescope
