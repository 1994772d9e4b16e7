// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace planescope {

/// The known name that is closest to a mistyped one, for "did you mean ...?". Distance is
/// Levenshtein's; the part before the last dot may be missing in `name` (`sigma` is near
/// `planes.sigma`). Ties go to the first. Empty if `known` is.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

}  // namespace planescope
