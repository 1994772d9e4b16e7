// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fit_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "planescope/error.hpp"

namespace planescope::draw {
namespace {

constexpr std::size_t kSample = 200'000;

std::vector<Eigen::Vector3f> sample(const Result& result, const Cutaway& cut, bool in_segments) {
  std::vector<Eigen::Vector3f> points;
  const std::size_t step = 1 + result.cloud.size() / kSample;
  for (std::size_t i = 0; i < result.cloud.size(); i += step) {
    const Eigen::Vector3f& p = result.cloud.positions[i];
    if (!is_finite(p) || (in_segments && result.point_label[i] == kNoSegment)) continue;
    if (!cut.hides(p, result.point_plane[i])) points.push_back(p);
  }
  return points;
}

/// The value that would stand at `index` if all were sorted; quicker than to sort them.
float ranked(std::vector<float>& values, std::size_t index) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Lower and upper end of the values without strays.
std::pair<float, float> limits(std::vector<float> values) {
  const auto [first, last] = std::minmax_element(values.begin(), values.end());
  const float least = *first, most = *last;
  std::pair<float, float> ends{least, most};
  for (const auto& [share, room] :
       std::array<std::array<float, 2>, 3>{{{0.005F, 0.1F}, {0.02F, 0.2F}, {0.05F, 0.3F}}}) {
    const auto outer = static_cast<std::size_t>(static_cast<float>(values.size()) * share);
    const float low = ranked(values, outer), high = ranked(values, values.size() - 1 - outer);
    if (low - least > room * (most - least)) ends.first = low;
    if (most - high > room * (most - least)) ends.second = high;
  }
  return ends;
}

}  // namespace

std::vector<Eigen::Vector3f> points_to_fit(const Result& result, const SceneFrame& frame,
                                           const Cutaway& cut) {
  std::vector<Eigen::Vector3f> points = sample(result, cut, true);
  if (points.empty()) points = sample(result, cut, false);
  if (points.empty()) {
    throw Error(Error::Kind::Input,
                "nothing to draw: the scene has no finite point; is the input whole?");
  }
  for (const Eigen::Vector3d& direction : {frame.right(), frame.front, frame.up}) {
    const Eigen::Vector3f axis = direction.cast<float>();
    std::vector<float> values;
    values.reserve(points.size());
    for (const Eigen::Vector3f& p : points) values.push_back(p.dot(axis));
    const auto [low, high] = limits(std::move(values));
    std::erase_if(points, [&, l = low, h = high](const Eigen::Vector3f& p) {
      return p.dot(axis) < l || p.dot(axis) > h;
    });
  }
  return points;
}

}  // namespace planescope::draw
