// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "validate.hpp"

#include <cmath>
#include <string>

#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

void refuse(const std::string& what) { throw Error(Error::Kind::Usage, what); }

void validate(const CameraOptions& camera) {
  const auto angle = [](const char* name, const std::optional<double>& value, double most) {
    if (value && !(std::abs(*value) <= most))
      refuse(std::string(name) + " " + std::to_string(*value) + ": must be " +
             std::to_string(static_cast<int>(-most)) + " to " +
             std::to_string(static_cast<int>(most)) + " degrees");
  };
  angle("azimuth", camera.azimuth, 360);
  angle("elevation", camera.elevation, 90);
  angle("roll", camera.roll, 360);
  if (!(camera.zoom >= 0.01 && camera.zoom <= 100))
    refuse("zoom " + std::to_string(camera.zoom) + ": must be 0.01 to 100");
  if (camera.focal && !camera.focal->allFinite()) refuse("focal: must be a place");
}

}  // namespace

void validate(const RenderOptions& options) {
  for (const int side : options.size) {
    if (side < 16 || side > 16384)
      refuse("picture size " + std::to_string(options.size[0]) + "x" +
             std::to_string(options.size[1]) + ": each side must be 16 to 16384 pixels");
  }
  if (std::int64_t{options.size[0]} * options.size[1] > kMostPixels)
    refuse("picture size " + std::to_string(options.size[0]) + "x" +
           std::to_string(options.size[1]) +
           ": at most 67108864 pixels in all (8192x8192); ask for less");
  if (options.supersample < 1 || options.supersample > 4)
    refuse("supersample " + std::to_string(options.supersample) + ": must be 1 to 4");
  for (const double channel : options.background)
    if (!(channel >= 0 && channel <= 1)) refuse("background: each channel must be 0 to 1");
  if (!(options.point_size >= 0 && options.point_size <= 100))
    refuse("point size " + std::to_string(options.point_size) + ": must be 0 to 100 pixels");
  if (!(options.dpi == 0 || (options.dpi >= 1 && options.dpi <= 10000)))
    refuse("dpi " + std::to_string(options.dpi) + ": must be 1 to 10000");
  validate(options.camera);
  if (options.color_by == ColorBy::Truth && options.truth.empty())
    refuse("color by truth: there is no truth; name a cloud with true labels");
  if (options.up && !(options.up->allFinite() && options.up->norm() > 0))
    refuse("up: must be a direction, such as 0,0,1");
}

}  // namespace planescope::draw
