// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planescope/synthesize.hpp"

#include <cmath>
#include <string>

#include "planescope/error.hpp"
#include "synthesize/room.hpp"
#include "synthesize/sampling.hpp"
#include "synthesize/views.hpp"

namespace planescope {
namespace {

void require(bool holds, const std::string& what, const std::string& range) {
  if (!holds) throw Error(Error::Kind::Usage, "synthesize: " + what + "; expected " + range);
}

void validate(const SynthesisOptions& options) {
  constexpr std::uint64_t kMaxPoints = 16'000'000;
  constexpr std::uint32_t kMaxViews = 1000;
  constexpr double kMaxNoise = 0.2, kMaxOffset = 1e9;
  require(options.views <= kMaxViews, "views is " + std::to_string(options.views), "0 to 1000");
  require(options.views > 0 || (options.points >= 1 && options.points <= kMaxPoints),
          "points is " + std::to_string(options.points), "1 to 16000000");
  require(options.noise >= 0 && options.noise <= kMaxNoise,
          "noise is " + std::to_string(options.noise) + " m", "0 to 0.2 m");
  require((options.offset.array().abs() <= kMaxOffset).all(),
          "offset is (" + std::to_string(options.offset.x()) + ", " +
              std::to_string(options.offset.y()) + ", " + std::to_string(options.offset.z()) +
              ") m",
          "at most 1e9 m along each axis");
}

}  // namespace

SynthesizedScene synthesize(const SynthesisOptions& options) {
  validate(options);
  const synthesis::Room room = synthesis::make_room(options.random_seed, options.ceiling);
  // Adding zero turns a negative zero, which would be written as such, into a positive one.
  const Eigen::Vector3d whole =
      options.offset.unaryExpr([](double x) { return std::trunc(x) + 0.0; });
  const Eigen::Vector3d rest = options.offset - whole;
  SynthesizedScene made = options.views > 0 ? synthesis::see_room(room, options, rest)
                                            : synthesis::sample_evenly(room.scene, options, rest);
  made.cloud.origin = whole;
  return made;
}

}  // namespace planescope
