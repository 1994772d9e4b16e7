// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>
#include <string>

#include "planescope/options.hpp"

namespace planescope {

std::string scale_warning(const CloudScale& scale, const Options& options) {
  constexpr double kLargestBuilding = 500, kSparsestScan = 0.5;  // [m] extent, spacing
  if (options.patches.range_exponent > 0 || scale.spacing <= options.patches.voxel_size) return {};
  std::ostringstream text;
  text << "points lie about " << scale.spacing << " m apart, further than --voxel-size "
       << options.patches.voxel_size << " m: most of them are alone in their voxel";
  if (double(scale.extent.norm()) > kLargestBuilding && scale.spacing > kSparsestScan)
    text << "; extent and spacing look like millimetres: scale the cloud to metres";
  else
    text << "; take larger voxels, or --preset auto";
  return text.str();
}

}  // namespace planescope
