// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/camera.hpp"
#include "planescope/render.hpp"
#include "png_chunks.hpp"
#include "scene_data.hpp"

/// \file What a picture says of how it was made, so that it can be made again.
namespace planescope::draw {

/// PNG texts: `Software` (planescope and VTK), `Source` (input and the hash of its bytes),
/// `planescope:options` (hash of the engine's options), `planescope:camera` (camera_json()),
/// `planescope:drawing` (layers and drawing options as JSON), `Title` where there is one; and the
/// resolution. Nothing in them differs from run to run.
PngNotes provenance(const SceneData& scene, const RenderOptions& options, Layer layers,
                    const Camera& camera);

/// The camera of a drawing, which is relative to the cloud's origin, in world coordinates.
Camera in_world(Camera camera, const SceneData& scene);

/// `segment`, `plane`, ... as on the command line, indexed by ColorBy; likewise palettes.
const char* name(ColorBy by);
const char* name(Palette palette);

}  // namespace planescope::draw
