// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planescope/explain.hpp"

namespace planescope {

/// What an explanation shows of a patch.
PatchReport report_patch(const Segmentation& scene, std::uint32_t id);

}  // namespace planescope
