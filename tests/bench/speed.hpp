// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "report.hpp"

namespace planescope::bench {

struct Inputs;  ///< clouds, made when first asked for

/// Registers all timings. `data` is the folder of shared data; without it the Kinect view's are
/// left out.
std::shared_ptr<Inputs> register_timings(const std::filesystem::path& data);

/// What is promised about those timings.
std::vector<Ratio> promised_ratios();

}  // namespace planescope::bench
