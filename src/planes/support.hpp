// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "planescope/pipeline.hpp"

namespace planescope {

/// The supporting planes as the assignment left them, and which one each patch lies on.
struct Support {
  std::vector<SupportingPlane> planes;  ///< those that have patches, by area, descending
  std::vector<PatchPlane> patch_plane;  ///< per patch; margins: measure_margins()
};

/// Refits each selected plane to the patches that were assigned to it (weighted by area), drops
/// those that were left without any, and puts the largest first. The paper keeps the planes as they
/// were proposed; the refit takes their bias from patches that the assignment gave to another
/// plane. \param assignment per patch: index into `selection.selected`, or kNone.
Support refit_planes(const PatchGraph& graph, const PlaneSelection& selection,
                     const std::vector<std::int32_t>& assignment);

/// How clearly each patch lies on its supporting plane, or on none (PatchPlane::margin), once the
/// planes are where they stay. Faces among `planes` do not count.
void measure_margins(std::vector<PatchPlane>& patch_plane, std::span<const Patch> patches,
                     std::span<const SupportingPlane> planes, const PlaneOptions& options);

}  // namespace planescope
