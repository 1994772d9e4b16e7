// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "splats.hpp"

#include <cmath>
#include <utility>

#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace planescope::draw {
namespace {

constexpr double kOverlap = 1.7;  // splat over spacing: random samples close to the eye

constexpr double kDisc = 1.13;  // diameter of a disc over the side of a square of its area
constexpr double kSurface = 6;  // points: patches of fewer are strays between surfaces

/// The median of values, 0 without any.
float median(std::vector<float> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// sqrt(area / points) of each patch [m], from a quarter to twice their median; strays no
/// more than half of it.
std::vector<float> patch_spacings(const SceneData& scene) {
  vtkDataArray& area = *scene.patches->GetPointData()->GetArray("area");
  vtkDataArray& count = *scene.patches->GetPointData()->GetArray("point_count");
  std::vector<float> spacings;
  for (vtkIdType i = 0; i < area.GetNumberOfTuples(); ++i) {
    const double ratio = area.GetTuple1(i) / std::max(count.GetTuple1(i), 1.0);
    spacings.push_back(static_cast<float>(std::sqrt(std::max(ratio, 0.0))));
  }
  const float usual = median(spacings);
  for (std::size_t i = 0; i < spacings.size(); ++i) {
    const bool stray = count.GetTuple1(static_cast<vtkIdType>(i)) < kSurface;
    spacings[i] = std::clamp(spacings[i], usual / 4, stray ? usual / 2 : usual * 2);
  }
  return spacings;
}

/// [m] What stands in for it where the method has no patches.
float cloud_spacing(const PointCloud& cloud) {
  return static_cast<float>(measure_scale(cloud).spacing);
}

}  // namespace

Splats splats(const SceneData& scene, const std::vector<std::uint32_t>& points) {
  const std::vector<float> spacing = patch_spacings(scene);
  const float usual = spacing.empty() ? cloud_spacing(scene.result.cloud) : median(spacing);
  const auto overlap = static_cast<float>(kOverlap);
  Splats splats{{}, static_cast<double>(overlap * usual)};
  splats.diameters.reserve(points.size());
  for (const std::uint32_t point : points) {
    const std::int32_t patch = scene.result.point_patch[point];
    splats.diameters.push_back(overlap *
                               (patch == kNone ? usual : spacing[static_cast<std::size_t>(patch)]));
  }
  return splats;
}

PointScale rounded(PointScale scale, double usual, double depth, double round_from) {
  const double pixels =
      scale.fixed > 0 ? scale.fixed : usual * scale.pixels_per_metre_at_1m / depth;
  if (pixels < round_from) return scale;
  scale.shape = SplatShape::Disc;
  scale.pixels_per_metre_at_1m *= kDisc;
  return scale;
}

}  // namespace planescope::draw
