// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planescope/synthesize.hpp"
#include "synthesize/scene.hpp"

namespace planescope::synthesis {

/// Divides `total` in proportion to the weights, exactly (largest remainder; ties to the lower
/// index). The weights are not negative and do not all vanish.
std::vector<std::uint64_t> apportion(std::uint64_t total, std::span<const double> weights);

/// Samples a scene evenly: exactly options.points points over what is visible of its surfaces,
/// surface by surface, noise along the normal.
/// \param shift [m] added to every position.
/// \returns the cloud (its origin not set), and the planes with the area that is visible.
SynthesizedScene sample_evenly(const Scene& scene, const SynthesisOptions& options,
                               const Vector3d& shift);

/// The plane of a planar surface as the cloud's user sees it, both moved by `pose`.
/// \param shown what the cloud shows of it, in the scene's frame.
TruePlane describe_plane(const Surface& surface, const VisiblePart& shown, const Isometry3d& pose);

}  // namespace planescope::synthesis
