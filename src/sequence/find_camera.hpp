// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "planescope/sequence.hpp"

namespace planescope::sequence {

/// The camera of a sequence, and in words where its intrinsics are from.
struct FoundCamera {
  CameraFile camera;
  std::string source;
};

/// From a file of the folder, else what is usual for the layout: PrimeSense, for 7-Scenes its own.
/// \throws Error{Kind::Input} the file is there but no camera.
FoundCamera find_camera(const std::filesystem::path& folder, SequenceLayout layout);

}  // namespace planescope::sequence
