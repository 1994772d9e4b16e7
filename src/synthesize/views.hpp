// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planescope/synthesize.hpp"
#include "synthesize/camera.hpp"
#include "synthesize/seen_area.hpp"

namespace planescope::synthesis {

/// The cloud that one depth camera gives: organised, in the camera's frame, NaN where there is no
/// return. Noise along the ray with standard deviation options.noise * z^2 (Khoshelham and
/// Elberink, Sensors 2012), so that every point still projects onto its pixel.
/// \param view render_depth() of the scene by that camera; \param stream tells views of one seed
/// apart.
PointCloud sense(const Scene& scene, const Camera& camera, const DepthView& view,
                 const SynthesisOptions& options, std::uint64_t stream);

/// The planes of the scene with the area that was seen of them, moved by `pose`.
std::vector<TruePlane> describe_seen(const Scene& scene, const SeenArea& seen,
                                     const Isometry3d& pose);

/// What options.views depth cameras see of the room. One: organised, in its frame. More: all
/// returns in the room's frame, view after view.
/// \param shift [m] added to every position.
/// \returns the cloud (its origin not set), and the planes with the area that was seen.
SynthesizedScene see_room(const Room& room, const SynthesisOptions& options, const Vector3d& shift);

}  // namespace planescope::synthesis
