// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "planescope/pipeline.hpp"
#include "planescope/result.hpp"

/// \file A result folder as segment() left it (target planescope::render, because VTK reads the
/// geometry): what asking why, trying options and drawing go by.
namespace planescope {

/// Everything that was stored of a scene.
struct StoredScene {
  Segmentation scene;  ///< as it was; times are zero, hypotheses of no more than lambda inliers
                       ///< have no plane
  PointCloud cloud;    ///< the input's points and colours; labels and normals are not kept
  InputInfo input;
};

/// Reads all files of a folder back. Patches (but for colours, rounded to bytes), edges, planes and
/// hypotheses are what they were, to the bit (but for map coordinates, which are rounded by less
/// than a micrometre). \throws Error{Kind::Input} a file is missing or malformed, or they do not
/// belong together.
StoredScene load_scene(const std::filesystem::path& folder);

}  // namespace planescope
