// SPDX-FileCopyrightText: 2026 the planescope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "planescope/sweep.hpp"

/// \file A sweep as a plot (target planescope::render).
namespace planescope {

struct SweepPlotOptions {
  std::array<int, 2> size = {1200, 1000};  ///< [pixel] at least 320 x 320
  std::string title;
};

/// Three charts over the values of the option: numbers of segments and planes; edges that differ
/// from the stored run (or numbers of patches and OFF edges, where patches are others); scores.
/// \throws Error{Kind::Usage} too small, or no row; otherwise as render().
void plot_sweep(const SweepRange& range, const std::vector<SweepRow>& rows,
                const SweepPlotOptions& options, const std::filesystem::path& png);

}  // namespace planescope
